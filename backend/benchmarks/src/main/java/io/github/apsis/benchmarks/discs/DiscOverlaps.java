package io.github.apsis.benchmarks.discs;

import io.github.apsis.engine.collision.Boundary.HalfPlane;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * How deep discs are in each other and in walls, as shares of a radius, by a sweep along x.
 *
 * @param deepest of all
 * @param mean of those that overlap; 0 where none does
 */
public record DiscOverlaps(double deepest, double mean) {
    public static DiscOverlaps of(DiscScene scene, DiscEngine engine) {
        List<Integer> order = new ArrayList<>();
        for (int i = 0; i < scene.discs().size(); i++) {
            order.add(i);
        }
        order.sort(Comparator.comparingDouble(engine::x));
        double widest =
                scene.discs().stream().mapToDouble(DiscScene.Disc::radius).max().orElse(0);
        var found = new Sum();
        for (int a = 0; a < order.size(); a++) {
            int i = order.get(a);
            double radius = scene.discs().get(i).radius();
            for (HalfPlane wall : scene.walls()) {
                found.add((radius - (wall.nx() * engine.x(i) + wall.ny() * engine.y(i) - wall.d())) / radius);
            }
            for (int b = a + 1; b < order.size() && engine.x(order.get(b)) - engine.x(i) < radius + widest; b++) {
                int j = order.get(b);
                double reach = radius + scene.discs().get(j).radius();
                double distance = Math.hypot(engine.x(j) - engine.x(i), engine.y(j) - engine.y(i));
                found.add((reach - distance)
                        / Math.min(radius, scene.discs().get(j).radius()));
            }
        }
        return new DiscOverlaps(found.deepest, found.count == 0 ? 0 : found.sum / found.count);
    }

    private static final class Sum {
        private double deepest;
        private double sum;
        private int count;

        void add(double overlap) {
            if (overlap > 0) {
                deepest = Math.max(deepest, overlap);
                sum += overlap;
                count++;
            }
        }
    }
}

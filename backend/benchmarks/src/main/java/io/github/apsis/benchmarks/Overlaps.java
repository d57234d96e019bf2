package io.github.apsis.benchmarks;

import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Period;
import org.jspecify.annotations.Nullable;

/**
 * How deep circles lie in each other and in walls. Asks every pair, so that no broad phase of the engine has a say; that costs
 * no more than the potential energy of the same moment.
 *
 * @param deepest overlap of a pair, or of a body and a wall, as a share of the smaller radius; 0 for none
 * @param touching pairs with no more than a millionth of their radii between them
 */
public record Overlaps(double deepest, int touching) {
    private static final double TOUCH = 1e-6;

    /** The overlaps of these bodies in a world with this edge. */
    public static Overlaps of(WorldSnapshot now, Boundary boundary) {
        var period = boundary instanceof Boundary.Periodic p ? new Period(p.box()) : null;
        double deepest = boundary instanceof Boundary.Walls walls ? inWalls(now, walls.box()) : 0;
        int touching = 0;
        for (int i = 0; i < now.count(); i++) {
            for (int j = i + 1; j < now.count(); j++) {
                double size = now.radius(i) + now.radius(j);
                double gap = distance(now, i, j, period) - size;
                touching += gap <= TOUCH * size ? 1 : 0;
                double smaller = Math.min(now.radius(i), now.radius(j));
                deepest = gap < 0 && smaller > 0 ? Math.max(deepest, -gap / smaller) : deepest;
            }
        }
        return new Overlaps(deepest, touching);
    }

    private static double distance(WorldSnapshot now, int i, int j, @Nullable Period period) {
        double dx = now.x(j) - now.x(i);
        double dy = now.y(j) - now.y(i);
        if (period != null) {
            dx = period.nearestX(dx);
            dy = period.nearestY(dy);
        }
        return Math.sqrt(dx * dx + dy * dy);
    }

    private static double inWalls(WorldSnapshot now, Aabb box) {
        double deepest = 0;
        for (int i = 0; i < now.count(); i++) {
            double r = now.radius(i);
            double gapX = Math.min(now.x(i) - box.minX(), box.maxX() - now.x(i)) - r;
            double gapY = Math.min(now.y(i) - box.minY(), box.maxY() - now.y(i)) - r;
            double gap = Math.min(gapX, gapY);
            deepest = gap < 0 && r > 0 ? Math.max(deepest, -gap / r) : deepest;
        }
        return deepest;
    }
}

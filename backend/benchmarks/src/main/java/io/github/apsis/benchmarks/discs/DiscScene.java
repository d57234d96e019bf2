package io.github.apsis.benchmarks.discs;

import io.github.apsis.engine.collision.Boundary.HalfPlane;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.CompensatedSum;
import java.util.List;

/**
 * Discs without friction, as every engine can be told of them.
 *
 * @param walls along the axes
 * @param around where the scene is; an engine without half-planes makes its walls that long
 * @param wallThickness of engines whose walls are boxes, length
 * @param restitution of discs and walls alike
 */
public record DiscScene(
        String name,
        List<Disc> discs,
        List<HalfPlane> walls,
        Aabb around,
        double wallThickness,
        double fieldX,
        double fieldY,
        double restitution,
        double dt) {
    /** Of walls that are boxes, length: more than anything moves in a tick. */
    public static final double THICK = 20;

    /** One disc; a fixed one has no velocity. */
    public record Disc(double x, double y, double vx, double vy, double radius, double mass, boolean isFixed) {}

    /** Of all discs, as they move now. */
    public double kineticEnergy(DiscEngine engine) {
        var sum = new CompensatedSum();
        for (int i = 0; i < discs.size(); i++) {
            double v2 = engine.vx(i) * engine.vx(i) + engine.vy(i) * engine.vy(i);
            sum.add(0.5 * discs.get(i).mass() * v2);
        }
        return sum.value();
    }

    /** Of all discs, length / time. */
    public double fastest(DiscEngine engine) {
        double fastest = 0;
        for (int i = 0; i < discs.size(); i++) {
            fastest = Math.max(fastest, Math.hypot(engine.vx(i), engine.vy(i)));
        }
        return fastest;
    }

    /** A scene in a closed box. */
    public static DiscScene boxed(
            String name, List<Disc> discs, Aabb box, double fieldY, double restitution, double dt) {
        List<HalfPlane> walls = List.of(
                new HalfPlane(1, 0, box.minX()),
                new HalfPlane(-1, 0, -box.maxX()),
                new HalfPlane(0, 1, box.minY()),
                new HalfPlane(0, -1, -box.maxY()));
        return new DiscScene(name, discs, walls, box, THICK, 0, fieldY, restitution, dt);
    }
}

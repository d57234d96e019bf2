package io.github.apsis.benchmarks.contacts;

import io.github.apsis.engine.collision.Boundary.HalfPlane;
import io.github.apsis.engine.math.Aabb;
import java.util.List;

/**
 * Discs without friction, as every engine can be told of them.
 *
 * @param walls along the axes
 * @param around where the scene is; an engine without half-planes makes its walls that long
 * @param wallThickness of engines whose walls are boxes, length
 * @param restitution of discs and walls alike
 */
record DiscScene(
        String name,
        List<Disc> discs,
        List<HalfPlane> walls,
        Aabb around,
        double wallThickness,
        double fieldX,
        double fieldY,
        double restitution,
        double dt) {
    private static final double THICK = 20;

    /** One disc; a fixed one has no velocity. */
    record Disc(double x, double y, double vx, double vy, double radius, double mass, boolean isFixed) {}

    /** A scene in a closed box. */
    static DiscScene boxed(String name, List<Disc> discs, Aabb box, double fieldY, double restitution, double dt) {
        List<HalfPlane> walls = List.of(
                new HalfPlane(1, 0, box.minX()),
                new HalfPlane(-1, 0, -box.maxX()),
                new HalfPlane(0, 1, box.minY()),
                new HalfPlane(0, -1, -box.maxY()));
        return new DiscScene(name, discs, walls, box, THICK, 0, fieldY, restitution, dt);
    }

    /** The scene of a case, for engines that know nothing of cases; its walls must be along the axes. */
    static DiscScene of(ContactCase known, double dt) {
        List<Disc> discs = known.bodies().stream()
                .map(body -> new Disc(body.x(), body.y(), body.vx(), body.vy(), body.radius(), body.mass(), false))
                .toList();
        double reach = known.bodies().stream()
                .mapToDouble(body -> Math.max(Math.abs(body.x()), Math.abs(body.y())) + body.radius())
                .max()
                .orElse(1);
        return new DiscScene(
                known.id(),
                discs,
                known.walls(),
                new Aabb(-reach, -reach, reach, reach),
                THICK,
                known.fieldX(),
                known.fieldY(),
                known.restitution(),
                dt);
    }
}

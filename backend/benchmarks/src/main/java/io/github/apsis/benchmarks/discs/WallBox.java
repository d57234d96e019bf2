package io.github.apsis.benchmarks.discs;

import io.github.apsis.engine.collision.Boundary.HalfPlane;
import io.github.apsis.engine.math.Aabb;

/** A half-plane along an axis as a box, for engines that have no half-planes. */
final class WallBox {
    private WallBox() {}

    /** As thick as the scene says, and longer than the scene by that on either end. */
    static Aabb of(HalfPlane wall, DiscScene scene) {
        double thick = scene.wallThickness();
        Aabb around = scene.around();
        if (Math.abs(wall.nx()) == 1 && wall.ny() == 0) {
            double face = wall.d() * wall.nx();
            double back = face - wall.nx() * thick;
            return new Aabb(Math.min(face, back), around.minY() - thick, Math.max(face, back), around.maxY() + thick);
        }
        if (Math.abs(wall.ny()) == 1 && wall.nx() == 0) {
            double face = wall.d() * wall.ny();
            double back = face - wall.ny() * thick;
            return new Aabb(around.minX() - thick, Math.min(face, back), around.maxX() + thick, Math.max(face, back));
        }
        throw new IllegalArgumentException("no box has the slope of " + wall);
    }
}

package io.github.apsis.server.room;

import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Vec2;
import java.util.Optional;

/** Where a world ends. */
public final class Edges {
    private Edges() {}

    /** The box of a bounded world; empty for an open one. */
    public static Optional<Aabb> box(Boundary boundary) {
        if (boundary instanceof Boundary.Walls walls) {
            return Optional.of(walls.box());
        }
        return boundary instanceof Boundary.Periodic periodic ? Optional.of(periodic.box()) : Optional.empty();
    }

    static boolean isOutside(Boundary boundary, Vec2 point) {
        return box(boundary).filter(box -> !box.contains(point.x(), point.y())).isPresent();
    }
}

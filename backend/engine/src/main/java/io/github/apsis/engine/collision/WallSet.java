package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Aabb;

/** The four sides of a box as partners in a contact, numbered −1 to −4; a normal points inwards. */
final class WallSet {
    static final int LEFT = -1;
    static final int RIGHT = -2;
    static final int BOTTOM = -3;
    static final int TOP = -4;

    private final Aabb box;

    WallSet(Aabb box) {
        this.box = box;
    }

    static double normalX(int wall) {
        return wall == LEFT ? 1 : wall == RIGHT ? -1 : 0;
    }

    static double normalY(int wall) {
        return wall == BOTTOM ? 1 : wall == TOP ? -1 : 0;
    }

    /** Distance from the rim of a circle at (x, y) to a wall; negative beyond it. */
    double gap(int wall, double x, double y, double radius) {
        return switch (wall) {
            case LEFT -> x - box.minX() - radius;
            case RIGHT -> box.maxX() - x - radius;
            case BOTTOM -> y - box.minY() - radius;
            default -> box.maxY() - y - radius;
        };
    }

    /** Whether a body ends its path inside, clear of all walls: by far the usual case, and the path of a tick is short. */
    boolean contains(Bodies bodies, int i) {
        double r = bodies.radius(i);
        return bodies.x(i) - r > box.minX()
                && bodies.x(i) + r < box.maxX()
                && bodies.y(i) - r > box.minY()
                && bodies.y(i) + r < box.maxY();
    }
}

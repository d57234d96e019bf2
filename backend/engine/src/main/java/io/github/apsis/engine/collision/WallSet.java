package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.collision.Boundary.HalfPlane;
import io.github.apsis.engine.math.Aabb;
import java.util.List;
import org.jspecify.annotations.Nullable;

/** Straight walls as partners in a contact, numbered −1, −2, … in the order of their boundary; a normal points inwards. */
public final class WallSet {
    private final double[] nx;
    private final double[] ny;
    private final double[] offset;

    private WallSet(List<HalfPlane> insides) {
        nx = insides.stream().mapToDouble(HalfPlane::nx).toArray();
        ny = insides.stream().mapToDouble(HalfPlane::ny).toArray();
        offset = insides.stream().mapToDouble(HalfPlane::d).toArray();
    }

    /** The walls of a boundary, or null when it has none. */
    public static @Nullable WallSet of(Boundary boundary) {
        if (boundary instanceof Boundary.Walls walls) {
            Aabb box = walls.box();
            return new WallSet(List.of(
                    new HalfPlane(1, 0, box.minX()),
                    new HalfPlane(-1, 0, -box.maxX()),
                    new HalfPlane(0, 1, box.minY()),
                    new HalfPlane(0, -1, -box.maxY())));
        }
        return boundary instanceof Boundary.HalfPlanes halfPlanes ? new WallSet(halfPlanes.insides()) : null;
    }

    /** The number of the wall after the last: walls are counted down from −1. */
    public int end() {
        return -1 - nx.length;
    }

    public double normalX(int wall) {
        return nx[-1 - wall];
    }

    public double normalY(int wall) {
        return ny[-1 - wall];
    }

    /** Distance from the rim of a circle at (x, y) to a wall; negative beyond it. */
    public double gap(int wall, double x, double y, double radius) {
        int k = -1 - wall;
        return nx[k] * x + ny[k] * y - offset[k] - radius;
    }

    /** Whether a body ends its path inside, clear of all walls by so much: by far the usual case, and the path of a tick is short. */
    boolean contains(Bodies bodies, int i, double margin) {
        boolean clear = true;
        for (int k = 0; k < nx.length; k++) {
            clear &= nx[k] * bodies.x(i) + ny[k] * bodies.y(i) - offset[k] > bodies.radius(i) + margin;
        }
        return clear;
    }
}

package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.collision.Boundary.HalfPlane;
import io.github.apsis.engine.math.Aabb;
import java.util.List;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/** Straight walls as partners in a contact, numbered −1, −2, … in the order of their boundary; a normal points inwards. */
public final class WallSet {
    private final double[] nx;
    private final double[] ny;
    private final double[] offset;

    // What walls along the axes leave: four comparisons, where a look at each wall would be most of a quiet tick.
    private final double minX;
    private final double minY;
    private final double maxX;
    private final double maxY;
    private final int[] slanted; // the other walls

    private WallSet(List<HalfPlane> insides) {
        nx = insides.stream().mapToDouble(HalfPlane::nx).toArray();
        ny = insides.stream().mapToDouble(HalfPlane::ny).toArray();
        offset = insides.stream().mapToDouble(HalfPlane::d).toArray();
        minX = innermost(1, 0);
        minY = innermost(0, 1);
        maxX = -innermost(-1, 0);
        maxY = -innermost(0, -1);
        slanted = IntStream.range(0, nx.length)
                .filter(k -> nx[k] != 0 && ny[k] != 0 || Math.abs(nx[k] + ny[k]) != 1)
                .toArray();
    }

    private double innermost(double normalX, double normalY) {
        return IntStream.range(0, nx.length)
                .filter(k -> nx[k] == normalX && ny[k] == normalY)
                .mapToDouble(k -> offset[k])
                .max()
                .orElse(Double.NEGATIVE_INFINITY);
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

    /** Finds the gap of every body to the nearest wall, at the end of its path. */
    void findGaps(Bodies bodies, double[] gaps) {
        bodies.findGaps(minX, minY, maxX, maxY, gaps);
        for (int k : slanted) {
            bodies.narrowGaps(nx[k], ny[k], offset[k], gaps);
        }
    }

    /** Whether a body ends its path inside, clear of all walls by so much: by far the usual case, and the path of a tick is short. */
    boolean contains(Bodies bodies, int i, double margin) {
        double x = bodies.x(i);
        double y = bodies.y(i);
        double away = bodies.radius(i) + margin;
        boolean clear = x - minX > away & maxX - x > away & y - minY > away & maxY - y > away;
        for (int k : slanted) {
            clear &= nx[k] * x + ny[k] * y - offset[k] > away;
        }
        return clear;
    }
}

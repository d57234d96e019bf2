package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.spatial.Quadtree;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Finds the bodies whose paths through the tick come near a body's own: a quadtree over the boxes that the moving circles
 * sweep, so that nothing fast is overlooked.
 */
final class BroadPhase {
    /** Where something is so fast that its path spans more periods, every body is near. */
    private static final int MOST_IMAGES = 25;

    private final Quadtree tree = new Quadtree();
    private final @Nullable Period period;

    private double boxMinX;
    private double boxMinY;
    private double boxMaxX;
    private double boxMaxY;

    private int[] near = new int[16];

    BroadPhase(@Nullable Period period) {
        this.period = period;
    }

    /** Puts the swept box of every body into the tree. */
    void build(Bodies bodies, Paths paths) {
        tree.begin(bodies.count());
        for (int i = 0; i < bodies.count(); i++) {
            sweep(bodies, paths, i);
            tree.set(i, boxMinX, boxMinY, boxMaxX, boxMaxY);
        }
        tree.build();
    }

    /** Tells the tree that the path of a body has been bent. */
    void update(Bodies bodies, Paths paths, int i) {
        sweep(bodies, paths, i);
        tree.enlarge(i, boxMinX, boxMinY, boxMaxX, boxMaxY);
    }

    private void sweep(Bodies bodies, Paths paths, int i) {
        double length = paths.dt() - paths.startTime(i);
        // A parabola leaves its chord by a T²/8 at most; a body that is stopped by another is a T² from where it would
        // be.
        double bulge = length * length / 8 + paths.dt() * paths.dt();
        double reachX = bodies.radius(i) + Math.abs(Paths.accelerationX(bodies, i)) * bulge;
        double reachY = bodies.radius(i) + Math.abs(Paths.accelerationY(bodies, i)) * bulge;
        boxMinX = Math.min(paths.startX(i), bodies.x(i)) - reachX;
        boxMinY = Math.min(paths.startY(i), bodies.y(i)) - reachY;
        boxMaxX = Math.max(paths.startX(i), bodies.x(i)) + reachX;
        boxMaxY = Math.max(paths.startY(i), bodies.y(i)) + reachY;
    }

    /**
     * Finds the bodies, in a fixed order, whose paths may touch the present path of body {@code i}; itself is among
     * them. In a periodic world also across the seam.
     *
     * @return how many; {@link #near} gives them until the next call
     */
    int findNear(Bodies bodies, Paths paths, int i) {
        sweep(bodies, paths, i);
        if (period == null) {
            return append(0, 0, 0);
        }
        double firstColumn = Math.ceil((tree.minX() - boxMaxX) / period.width());
        double lastColumn = Math.floor((tree.maxX() - boxMinX) / period.width());
        double firstRow = Math.ceil((tree.minY() - boxMaxY) / period.height());
        double lastRow = Math.floor((tree.maxY() - boxMinY) / period.height());
        if (!((lastColumn - firstColumn + 1) * (lastRow - firstRow + 1) <= MOST_IMAGES)) {
            return all(bodies.count());
        }
        int hits = 0;
        for (double column = firstColumn; column <= lastColumn; column++) {
            for (double row = firstRow; row <= lastRow; row++) {
                hits = append(hits, column * period.width(), row * period.height());
            }
        }
        return hits;
    }

    private int all(int count) {
        if (count > near.length) {
            near = new int[Math.max(count, 2 * near.length)];
        }
        for (int i = 0; i < count; i++) {
            near[i] = i;
        }
        return count;
    }

    private int append(int before, double shiftX, double shiftY) {
        int found = tree.query(boxMinX + shiftX, boxMinY + shiftY, boxMaxX + shiftX, boxMaxY + shiftY);
        if (before + found > near.length) {
            near = Arrays.copyOf(near, Math.max(2 * near.length, before + found));
        }
        for (int hit = 0; hit < found; hit++) {
            near[before + hit] = tree.found(hit);
        }
        return before + found;
    }

    int near(int hit) {
        return near[hit];
    }
}

package io.github.apsis.engine.force;

import io.github.apsis.engine.spatial.Quadtree;
import java.util.Arrays;

/**
 * The way down a {@link MassTree}, by one thread: what pulls a cell, then what pulls its children.
 *
 * <pre>
 *   a source apart from the cell pulls it by its expansion,
 *   a larger one is opened, and a smaller one left to the children of the cell;
 *   what is left to a leaf is leaves, and pulls it body by body
 * </pre>
 *
 * <p>Who opens whom depends on the pair and not on who asks, so a pulls b by what b pulls a by: momentum is conserved to
 * rounding, although each end is worked out for itself. Both ends at once would spare a set of derivatives, and write to each
 * other's cells; so every cell is written by one thread, in an order that is always the same.
 */
final class CellWalk {
    /** Ordered pairs of bodies in two leaves that take no longer than their expansions. */
    private static final int FEW_PAIRS = 64;

    private final MassTree masses;
    private final Quadtree tree;
    private final CellKernels kernels;
    private final NearSources near;

    private int[] left = new int[1024]; // sources left to children, level behind level
    private int filled;
    private int[] nearLeaf = new int[64]; // ascending
    private int nearLeaves;
    private int[] boughFrom = new int[64]; // where the sources of a bough begin and end, for the walk down the trunk
    private int[] boughTo = new int[64];
    private int boughs;
    private long cellPairs; // ordered, since the beginning
    private long bodyPairs;

    CellWalk(MassTree masses, CellKernels kernels, double softening) {
        this.masses = masses;
        this.tree = masses.tree();
        this.kernels = kernels;
        this.near = new NearSources(softening);
    }

    /** Forgets what was counted and what was left. */
    void begin() {
        cellPairs = 0;
        bodyPairs = 0;
        filled = 0;
    }

    /** How often a cell has pulled a cell. */
    long cellPairs() {
        return cellPairs;
    }

    /** How often a body has pulled a body. */
    long bodyPairs() {
        return bodyPairs;
    }

    /** Lets everything pull the cells of the trunk, and keeps what is left to the boughs. */
    void pullTrunk() {
        if (boughFrom.length < masses.boughs()) {
            boughFrom = new int[2 * masses.boughs()];
            boughTo = new int[2 * masses.boughs()];
        }
        boughs = 0;
        leave(0);
        pullTrunk(0, 0, 1);
    }

    private void pullTrunk(int cell, int from, int to) {
        if (cell == masses.bough(boughs)) {
            boughFrom[boughs] = from;
            boughTo[boughs] = to;
            boughs++;
            return;
        }
        int begin = filled;
        for (int k = from; k < to; k++) {
            meet(cell, left[k]);
        }
        int end = filled;
        for (int child = cell + 1; child < tree.past(cell); child = tree.past(child)) {
            passDown(cell, child);
            pullTrunk(child, begin, end);
        }
    }

    /** Lets everything that the walk down the trunk has left to a bough pull its cells and bodies. */
    void pullBough(int bough, CellWalk trunk) {
        pull(masses.bough(bough), trunk.left, trunk.boughFrom[bough], trunk.boughTo[bough]);
    }

    private void pull(int cell, int[] sources, int from, int to) {
        int begin = filled;
        nearLeaves = 0;
        for (int k = from; k < to; k++) {
            meet(cell, sources[k]);
        }
        if (tree.isLeaf(cell)) {
            pullNear(cell);
            passToBodies(cell);
            return; // nothing is left
        }
        int end = filled;
        for (int child = cell + 1; child < tree.past(cell); child = tree.past(child)) {
            passDown(cell, child);
            pull(child, left, begin, end);
        }
        filled = begin;
    }

    private void meet(int cell, int source) {
        if (source == cell) {
            meetItself(cell);
            return;
        }
        double dx = masses.centreX(cell) - masses.centreX(source);
        double dy = masses.centreY(cell) - masses.centreY(source);
        double reachOfBoth = masses.reach(cell) + masses.reach(source);
        boolean apart = reachOfBoth * reachOfBoth < dx * dx + dy * dy;
        boolean leaves = tree.isLeaf(cell) && tree.isLeaf(source);
        if (leaves && (!apart || tree.size(cell) * tree.size(source) <= FEW_PAIRS)) {
            keepNear(cell, source);
        } else if (apart) {
            kernels.pull(cell, source, dx, dy);
            cellPairs++;
        } else if (isOpened(source, cell)) {
            for (int child = source + 1; child < tree.past(source); child = tree.past(child)) {
                meet(cell, child);
            }
        } else {
            leave(source);
        }
    }

    private void meetItself(int cell) {
        if (tree.isLeaf(cell)) {
            keepNear(cell, cell);
        }
        for (int child = cell + 1; child < tree.past(cell); child = tree.past(child)) {
            leave(child);
        }
    }

    /** Whether of two different cells this one is divided, and not the other. */
    private boolean isOpened(int cell, int other) {
        if (tree.isLeaf(cell) || tree.isLeaf(other)) {
            return !tree.isLeaf(cell);
        }
        double reach = masses.reach(cell);
        double reachOfOther = masses.reach(other);
        return reach > reachOfOther || reach == reachOfOther && cell < other;
    }

    private void leave(int source) {
        if (filled == left.length) {
            left = Arrays.copyOf(left, 2 * filled);
        }
        left[filled++] = source;
    }

    private void keepNear(int leaf, int source) {
        if (nearLeaves == nearLeaf.length) {
            nearLeaf = Arrays.copyOf(nearLeaf, 2 * nearLeaves);
        }
        nearLeaf[nearLeaves++] = source;
        bodyPairs += (long) tree.size(leaf) * tree.size(source);
    }

    private void pullNear(int leaf) {
        near.clear();
        int k = 0;
        while (k < nearLeaves) {
            int start = tree.first(nearLeaf[k]);
            int stop = tree.end(nearLeaf[k++]);
            while (k < nearLeaves && tree.first(nearLeaf[k]) == stop) {
                stop = tree.end(nearLeaf[k++]); // neighbours in the order of the tree: one copy
            }
            near.add(masses.masses(), start, stop);
        }
        if (masses.isOrdinary()) {
            near.pull(masses.masses(), tree.first(leaf), tree.end(leaf));
        } else {
            near.pullWithCare(masses.masses(), tree.first(leaf), tree.end(leaf));
        }
    }

    private void passDown(int cell, int child) {
        if (masses.expands(cell)) {
            kernels.passDown(
                    cell,
                    child,
                    masses.centreX(child) - masses.centreX(cell),
                    masses.centreY(child) - masses.centreY(cell));
        }
    }

    private void passToBodies(int leaf) {
        if (masses.expands(leaf)) {
            PointMasses bodies = masses.masses();
            for (int k = tree.first(leaf); k < tree.end(leaf); k++) {
                kernels.passToBody(
                        leaf, bodies, k, bodies.x[k] - masses.centreX(leaf), bodies.y[k] - masses.centreY(leaf));
            }
        }
    }
}

package io.github.apsis.engine.force;

import static io.github.apsis.engine.force.CellKernels.LOCALS;

import io.github.apsis.engine.spatial.Quadtree;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * The way down a {@link MassTree}, by one thread: what pulls a cell, then what pulls its children.
 *
 * <pre>
 *   a source apart from the cell pulls it by its expansion,
 *   a larger one is opened, and a smaller one left to the children of the cell;
 *   what is left to a leaf is leaves, and pulls it body by body
 * </pre>
 *
 * <p>What pulls a cell from afar is only known while the walk is at the cell or below: a row of coefficients for every level.
 * A bough has the row that the walk down the trunk has left to it.
 *
 * <p>Who opens whom depends on the pair and not on who asks, so a pulls b by what b pulls a by: momentum is conserved to
 * rounding, although each end is worked out for itself. Both ends at once would spare a set of derivatives, and write to each
 * other's cells; so every cell is written by one thread, in an order that is always the same.
 */
final class CellWalk {
    /** Ordered pairs of bodies in two leaves that take no longer than their expansions. */
    private static final int FEW_PAIRS = 64;

    /** Sources of a giant that are copied before they pull it: as few as a leaf may have. */
    private static final int AT_ONCE = 512;

    private final MassTree masses;
    private final Quadtree tree;
    private final CellKernels kernels;
    private final NearSources near;
    private final Giants giants;
    private final double g; // length³ / (mass · time²)
    private final Pulls pulls = new Pulls();

    private double[] local = new double[8 * LOCALS]; // by level
    private double[] boughLocal = new double[0];
    private @Nullable Pulled to;
    private int[] left = new int[128]; // sources left to children, level behind level
    private int filled;
    private int[] nearLeaf = new int[64]; // ascending
    private int nearLeaves;
    private int[] boughFrom = new int[0]; // where the sources of a bough begin and end, for the walk down the trunk
    private int[] boughTo = new int[0];
    private int boughs;
    private long cellPairs; // ordered, since the beginning
    private long bodyPairs;

    CellWalk(MassTree masses, CellKernels kernels, Giants giants, double g, double softening) {
        this.g = g;
        this.masses = masses;
        this.tree = masses.tree();
        this.kernels = kernels;
        this.giants = giants;
        this.near = new NearSources(softening);
    }

    /** Forgets what was counted and what was left, and says who wants to know the accelerations. */
    void begin(Pulled pulled) {
        to = pulled;
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
            boughFrom = new int[masses.boughs() + masses.boughs() / 8];
            boughTo = new int[boughFrom.length];
            boughLocal = new double[boughFrom.length * LOCALS];
        }
        boughs = 0;
        leave(0);
        clear(0);
        pullTrunk(0, 0, 0, 1);
    }

    private void pullTrunk(int cell, int level, int from, int to) {
        if (cell == masses.bough(boughs)) {
            boughFrom[boughs] = from;
            boughTo[boughs] = to;
            System.arraycopy(local, level * LOCALS, boughLocal, boughs * LOCALS, LOCALS);
            boughs++;
            return;
        }
        int begin = filled;
        for (int k = from; k < to; k++) {
            meet(cell, level, left[k]);
        }
        int end = filled;
        for (int child = cell + 1; child < tree.past(cell); child = tree.past(child)) {
            passDown(cell, child, level);
            pullTrunk(child, level + 1, begin, end);
        }
    }

    private void clear(int level) {
        if ((level + 1) * LOCALS > local.length) {
            local = Arrays.copyOf(local, 2 * local.length);
        }
        Arrays.fill(local, level * LOCALS, (level + 1) * LOCALS, 0);
    }

    /** Lets everything that the walk down the trunk has left to a bough pull its cells and bodies. */
    void pullBough(int bough, CellWalk trunk) {
        System.arraycopy(trunk.boughLocal, bough * LOCALS, local, 0, LOCALS);
        pull(masses.bough(bough), 0, trunk.left, trunk.boughFrom[bough], trunk.boughTo[bough]);
    }

    private void pull(int cell, int level, int[] sources, int from, int to) {
        int begin = filled;
        nearLeaves = 0;
        for (int k = from; k < to; k++) {
            meet(cell, level, sources[k]);
        }
        if (tree.isLeaf(cell)) {
            pullBodies(cell, level);
            return; // nothing is left
        }
        int end = filled;
        for (int child = cell + 1; child < tree.past(cell); child = tree.past(child)) {
            passDown(cell, child, level);
            pull(child, level + 1, left, begin, end);
        }
        filled = begin;
    }

    private void meet(int cell, int level, int source) {
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
            kernels.pull(local, level, source, dx, dy);
            cellPairs++;
        } else if (isOpened(source, cell)) {
            for (int child = source + 1; child < tree.past(source); child = tree.past(child)) {
                meet(cell, level, child);
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

    private void pullBodies(int leaf, int level) {
        int start = tree.first(leaf);
        int stop = tree.end(leaf);
        pulls.begin(start, stop);
        pullNear(leaf);
        passToBodies(leaf, level);
        for (int k = start; k < stop; k++) {
            if (giants.contain(tree.item(k))) {
                pullGiant(k);
            }
        }
        for (int k = start; to != null && k < stop; k++) {
            to.accelerate(tree.item(k), g * pulls.x(k), g * pulls.y(k));
        }
    }

    /** Lets all bodies pull one of the giants, which cells do not. */
    private void pullGiant(int k) {
        pulls.clear(k);
        int count = masses.masses().count();
        for (int from = 0; from < count; from += AT_ONCE) {
            near.clear();
            near.add(masses.masses(), from, Math.min(count, from + AT_ONCE));
            pullByNear(k, k + 1);
        }
        near.clear();
        giants.addTo(near);
        pullByNear(k, k + 1);
    }

    private void pullNear(int leaf) {
        near.clear();
        giants.addTo(near);
        int k = 0;
        while (k < nearLeaves) {
            int start = tree.first(nearLeaf[k]);
            int stop = tree.end(nearLeaf[k++]);
            while (k < nearLeaves && tree.first(nearLeaf[k]) == stop) {
                stop = tree.end(nearLeaf[k++]); // neighbours in the order of the tree: one copy
            }
            near.add(masses.masses(), start, stop);
        }
        pullByNear(tree.first(leaf), tree.end(leaf));
    }

    private void pullByNear(int start, int stop) {
        if (masses.isOrdinary()) {
            near.pull(masses.masses(), start, stop, pulls);
        } else {
            near.pullWithCare(masses.masses(), start, stop, pulls);
        }
    }

    private void passDown(int cell, int child, int level) {
        clear(level + 1);
        if (masses.expands(cell)) {
            kernels.passDown(
                    local,
                    level,
                    level + 1,
                    masses.centreX(child) - masses.centreX(cell),
                    masses.centreY(child) - masses.centreY(cell));
        }
    }

    private void passToBodies(int leaf, int level) {
        if (masses.expands(leaf)) {
            PointMasses bodies = masses.masses();
            for (int k = tree.first(leaf); k < tree.end(leaf); k++) {
                kernels.passToBody(
                        local, level, pulls, k, bodies.x[k] - masses.centreX(leaf), bodies.y[k] - masses.centreY(leaf));
            }
        }
    }
}

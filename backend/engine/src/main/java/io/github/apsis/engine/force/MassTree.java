package io.github.apsis.engine.force;

import static io.github.apsis.engine.force.CellKernels.MOMENTS;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.parallel.Work;
import io.github.apsis.engine.spatial.Quadtree;
import io.github.apsis.engine.spatial.Workspace;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * A quadtree over masses, with the centre, the reach and the moments of every cell: the first half of {@link TreeGravity}.
 *
 * <p>The tree is cut into boughs: the largest subtrees with no more than a 32nd of the bodies, and what stands above them, the
 * trunk. Boughs do not need each other on the way up, and are the pieces of work. Where they are cut depends on the bodies
 * alone.
 */
final class MassTree implements Work {
    private static final int LEAF_SIZE = 40; // at equal error 32 to 48 take the same time within a twentieth
    private static final int SHARES =
            32; // a bough has one of so many of the bodies at most; with 64 the trunk took as long again

    /** Length; where 1/r⁷ and r⁵ are numbers. Cells larger or farther out pull body by body. */
    private static final double LARGEST = 1e40;

    private static final double SMALLEST = 1e-40;

    private static final double ROUNDING = 1 + 1e-9;

    private final CellKernels kernels;
    private final Giants giants;
    private final Workspace workspace;
    private final Quadtree tree;
    private final PointMasses masses;
    private double theta;
    private @Nullable Bodies bodies; // while at work

    private double[] centreX = new double[16];
    private double[] centreY = new double[16];
    private double[] cellMass = new double[16];
    private double[] reach = new double[16]; // r / θ

    private int boughs;
    private int[] bough = new int[64]; // their cells, ascending
    private int[] inTurn = new int[64]; // numbers of boughs, large ones first
    private boolean[] ordinaryBough = new boolean[64];
    private boolean ordinary; // no coordinate is so small that d³ underflows, or so large that d² overflows

    MassTree(CellKernels kernels, Giants giants, Team team, Workspace workspace) {
        this.workspace = workspace;
        this.tree = Quadtree.ofPoints(LEAF_SIZE, team, workspace);
        this.masses = new PointMasses(workspace); // in the columns of the points, which the tree no longer needs then
        this.kernels = kernels;
        this.giants = giants;
    }

    /** Sorts the bodies into a tree and works out its cells. */
    void plant(Bodies planted, double openingAngle, Team team) {
        theta = openingAngle;
        int count = planted.count();
        giants.find(planted);
        tree.begin(count);
        for (int i = 0; i < count; i++) {
            tree.setPoint(i, planted.x(i), planted.y(i));
        }
        tree.build();
        masses.begin(count);
        makeRoom();
        cutBoughs();
        bodies = planted;
        team.share(this, boughs);
        bodies = null;
        ordinary = true;
        for (int k = 0; k < boughs; k++) {
            ordinary &= ordinaryBough[k];
        }
        int next = boughs - 1;
        for (int cell = tree.nodes() - 1; cell >= 0; cell--) {
            if (next >= 0 && cell < tree.past(bough[next]) && cell >= bough[next]) {
                cell = bough[next--]; // done
            } else {
                workOut(cell);
            }
        }
    }

    private void makeRoom() {
        double[] moments = workspace.doubles(3, tree.nodes() * MOMENTS);
        Arrays.fill(moments, 0, tree.nodes() * MOMENTS, 0);
        kernels.use(moments);
        if (tree.nodes() > reach.length) {
            int capacity = tree.nodes() + tree.nodes() / 8;
            centreX = new double[capacity];
            centreY = new double[capacity];
            cellMass = new double[capacity];
            reach = new double[capacity];
        }
    }

    private void cutBoughs() {
        int most = Math.max(LEAF_SIZE, tree.items() / SHARES);
        boughs = 0;
        int cell = 0;
        while (cell < tree.nodes()) {
            if (tree.size(cell) > most && !tree.isLeaf(cell)) {
                cell++;
                continue;
            }
            if (boughs == bough.length) {
                bough = Arrays.copyOf(bough, 2 * boughs);
                inTurn = new int[2 * boughs];
                ordinaryBough = new boolean[2 * boughs];
            }
            bough[boughs++] = cell;
            cell = tree.past(cell);
        }
        takeLargeOnesFirst(most);
    }

    /** So that threads who share the boughs end together. */
    private void takeLargeOnesFirst(int most) {
        int turn = 0;
        int smaller = most;
        while (turn < boughs) {
            int larger = smaller;
            smaller = larger / 2;
            for (int k = 0; k < boughs; k++) {
                int size = Math.min(most, tree.size(bough[k]));
                if (size > smaller && size <= larger) {
                    inTurn[turn++] = k;
                }
            }
        }
    }

    /** Works out the cells of one bough. */
    @Override
    public void doPiece(int piece, int member) {
        int root = bough[piece];
        if (bodies != null) {
            masses.load(bodies, tree, giants, tree.first(root), tree.end(root));
        }
        ordinaryBough[piece] = NearSources.areOrdinary(masses, tree.first(root), tree.end(root));
        for (int cell = tree.past(root) - 1; cell >= root; cell--) { // children stand behind their parent
            workOut(cell);
        }
    }

    private void workOut(int cell) {
        findCentre(cell);
        findReach(cell);
        gather(cell);
    }

    private void findCentre(int cell) {
        double m = 0;
        double mx = 0;
        double my = 0;
        if (tree.isLeaf(cell)) {
            for (int k = tree.first(cell); k < tree.end(cell); k++) {
                m += masses.mass[k];
                mx += masses.mass[k] * masses.x[k];
                my += masses.mass[k] * masses.y[k];
            }
        } else {
            for (int child = cell + 1; child < tree.past(cell); child = tree.past(child)) {
                m += cellMass[child];
                mx += cellMass[child] * centreX[child];
                my += cellMass[child] * centreY[child];
            }
        }
        cellMass[cell] = m;
        // Any place will do for a cell without mass, as long as it is near.
        centreX[cell] = m == 0 ? masses.x[tree.first(cell)] : mx / m;
        centreY[cell] = m == 0 ? masses.y[tree.first(cell)] : my / m;
    }

    private void findReach(int cell) {
        double radius = Math.sqrt(farthest(cell));
        double extent = Math.abs(centreX[cell]) + Math.abs(centreY[cell]) + radius;
        reach[cell] = extent < LARGEST ? Math.max(radius / theta, SMALLEST) : Double.POSITIVE_INFINITY;
        for (int child = cell + 1; child < tree.past(cell); child = tree.past(child)) {
            reach[cell] =
                    Math.max(reach[cell], reach[child]); // so that what is above a cell without expansions has none
        }
    }

    /** The largest square of a distance from the centre. Most that is below the cell is nearer than something seen before, as a whole. */
    private double farthest(int cell) {
        double farthest = 0;
        int below = cell;
        while (below < tree.past(cell)) {
            if (below != cell && isNearer(below, cell, farthest)) {
                below = tree.past(below);
                continue;
            }
            if (tree.isLeaf(below)) {
                farthest =
                        Math.max(farthest, farthest(tree.first(below), tree.end(below), centreX[cell], centreY[cell]));
            }
            below++;
        }
        return farthest;
    }

    private boolean isNearer(int below, int cell, double farthest) {
        double dx = centreX[below] - centreX[cell];
        double dy = centreY[below] - centreY[cell];
        double most = Math.sqrt(dx * dx + dy * dy) + theta * reach[below];
        return most * most * ROUNDING < farthest;
    }

    /** The same of some bodies; four at a time, since each maximum waits for the one before. */
    private double farthest(int start, int stop, double cx, double cy) {
        double[] x = masses.x;
        double[] y = masses.y;
        double first = 0;
        double second = 0;
        double third = 0;
        double fourth = 0;
        int k = start;
        for (; k + 3 < stop; k += 4) {
            first = Math.max(first, distance2(x[k] - cx, y[k] - cy)); // NaN stays
            second = Math.max(second, distance2(x[k + 1] - cx, y[k + 1] - cy));
            third = Math.max(third, distance2(x[k + 2] - cx, y[k + 2] - cy));
            fourth = Math.max(fourth, distance2(x[k + 3] - cx, y[k + 3] - cy));
        }
        for (; k < stop; k++) {
            first = Math.max(first, distance2(x[k] - cx, y[k] - cy));
        }
        return Math.max(Math.max(first, second), Math.max(third, fourth));
    }

    private static double distance2(double dx, double dy) {
        return dx * dx + dy * dy;
    }

    private void gather(int cell) {
        if (!expands(cell)) {
            return;
        }
        if (tree.isLeaf(cell)) {
            for (int k = tree.first(cell); k < tree.end(cell); k++) {
                kernels.addBody(cell, masses.mass[k], masses.x[k] - centreX[cell], masses.y[k] - centreY[cell]);
            }
        } else {
            for (int child = cell + 1; child < tree.past(cell); child = tree.past(child)) {
                kernels.addChild(cell, child, centreX[child] - centreX[cell], centreY[child] - centreY[cell]);
            }
        }
    }

    /** The nodes. */
    Quadtree tree() {
        return tree;
    }

    /** The bodies in the order of the tree. */
    PointMasses masses() {
        return masses;
    }

    /** Whether distances between any of the bodies have cubes, unless they are 0. */
    boolean isOrdinary() {
        return ordinary;
    }

    /** Centre of mass. */
    double centreX(int cell) {
        return centreX[cell];
    }

    double centreY(int cell) {
        return centreY[cell];
    }

    /** The distance of the farthest body from the centre, over θ; infinite for a cell that has no expansion. */
    double reach(int cell) {
        return reach[cell];
    }

    boolean expands(int cell) {
        return reach[cell] < Double.POSITIVE_INFINITY;
    }

    /** How many boughs there are. */
    int boughs() {
        return boughs;
    }

    /** The bough whose turn it is, of those that threads share. */
    int inTurn(int turn) {
        return inTurn[turn];
    }

    /** The cell that a bough begins with. */
    int bough(int k) {
        return bough[k];
    }
}

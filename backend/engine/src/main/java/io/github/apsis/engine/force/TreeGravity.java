package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.spatial.Quadtree;
import java.util.OptionalDouble;

/**
 * Newtonian gravity by a tree whose cells pull each other: the law of {@link DirectGravity} to a chosen accuracy, in a time
 * that grows about like n.
 *
 * <pre>
 *   cells A and B pull each other by their expansions when  r_A + r_B &lt; θ · |z_A − z_B|,
 *   z = centre of mass, r = distance of the farthest body from it; otherwise the larger is divided,
 *   and leaves that are still too close pull each other body by body
 * </pre>
 *
 * <p>The mutual walk of Dehnen 2002 (J. Comput. Phys. 179, 27) with the expansions of {@link CellExpansions}. Both ends of
 * every interaction are served alike, so momentum is conserved to rounding; θ → 0 gives the direct sum. On a disc of 10 000
 * bodies θ = 0.5 errs by 7e-5 in the median and takes 6 ms, θ = 0.3 by 2e-6 in 13 ms; the direct sum takes 49 ms.
 *
 * <p>Other rules of opening bought nothing, measured at order 5: θ growing with falling mass (Dehnen's) has the same error in
 * the same time within 5 % on disc and Plummer sphere; opening by an estimate of the error beside the true pull of the
 * target saves a quarter of the body pairs in the sphere and nothing in the disc, and needs pulls that are not yet known.
 * Order 6 needs a quarter less time than order 5 for a median error of 1e-4.
 */
public final class TreeGravity implements ForceLaw {
    private static final int LEAF_SIZE = 32; // 16 to 48 take the same time; larger leaves err less

    /** Length; where 1/r⁷ and r⁵ are numbers. Cells larger or farther out pull body by body. */
    private static final double LARGEST = 1e40;

    private static final double SMALLEST = 1e-40;

    // In pairs of the direct sum of 0.9 ns each: measured on the reference discs.
    private static final double WORK_OF_BODY = 130;
    private static final double WORK_OF_CELLS = 110;
    private static final double WORK_OF_PAIR = 2;

    private final double g; // length³ / (mass · time²)
    private double theta;
    private final DirectGravity exact;
    private final Quadtree tree = new Quadtree(LEAF_SIZE);
    private final PointMasses masses;
    private final CellExpansions cells;
    private final NearPairs near = new NearPairs();

    private long cellPairs; // of the last walk
    private long bodyPairs;

    private double[] centreX = new double[16];
    private double[] centreY = new double[16];
    private double[] cellMass = new double[16];
    private double[] reach = new double[16]; // r / θ

    /**
     * Gravity with this opening angle.
     *
     * @param softening of Plummer, length
     * @param theta above 0, where it is the direct sum, and at most 1
     */
    public TreeGravity(double g, double softening, double theta) {
        if (!(theta > 0 && theta <= 1)) {
            throw new IllegalArgumentException("theta must be above 0 and at most 1, was " + theta);
        }
        this.g = g;
        this.theta = theta;
        this.exact = new DirectGravity(g, softening);
        this.masses = new PointMasses(softening);
        this.cells = new CellExpansions(softening);
    }

    /** The opening angle. */
    public double theta() {
        return theta;
    }

    /** Opens cells by another angle from now on. */
    void openAt(double angle) {
        theta = angle;
    }

    @Override
    public void apply(Bodies bodies) {
        compute(bodies);
        masses.giveTo(bodies, tree, g);
    }

    /** Works the accelerations out and keeps them. */
    void compute(Bodies bodies) {
        cellPairs = 0;
        bodyPairs = 0;
        plantTree(bodies);
        masses.load(bodies, tree);
        if (bodies.count() > 0) {
            gatherMoments();
            near.begin();
            pullWithin(0);
            near.sort(tree.nodes());
            for (int cell = 0; cell < tree.nodes(); cell++) {
                passDown(cell);
                pullNear(cell);
            }
        }
    }

    /** The accelerations that were worked out last, by slot. */
    void copyAccelerations(double[] toX, double[] toY) {
        masses.copyTo(toX, toY, tree, g);
    }

    /** What the last walk cost, in pairs of the direct sum: counted, so that it is the same on every machine. */
    double work() {
        return WORK_OF_BODY * tree.items() + WORK_OF_CELLS * cellPairs + WORK_OF_PAIR * bodyPairs;
    }

    /** As for {@link DirectGravity#potential}: exact, and n²/2 pairs dear. */
    @Override
    public OptionalDouble potential(Bodies bodies) {
        return exact.potential(bodies);
    }

    private void plantTree(Bodies bodies) {
        tree.begin(bodies.count());
        for (int i = 0; i < bodies.count(); i++) {
            tree.set(i, bodies.x(i), bodies.y(i), bodies.x(i), bodies.y(i));
        }
        tree.build();
    }

    private void gatherMoments() {
        int nodes = tree.nodes();
        if (nodes > reach.length) {
            centreX = new double[2 * nodes];
            centreY = new double[2 * nodes];
            cellMass = new double[2 * nodes];
            reach = new double[2 * nodes];
        }
        cells.begin(nodes);
        for (int cell = nodes - 1; cell >= 0; cell--) { // children stand behind their parent
            findCentre(cell);
            findReach(cell);
            gather(cell);
        }
    }

    private void findCentre(int cell) {
        double m = 0;
        double mx = 0;
        double my = 0;
        if (tree.isLeaf(cell)) {
            for (int k = tree.first(cell); k < tree.end(cell); k++) {
                m += masses.mass(k);
                mx += masses.mass(k) * masses.x(k);
                my += masses.mass(k) * masses.y(k);
            }
        } else {
            for (int child = cell + 1; child < tree.past(cell); child = tree.past(child)) {
                m += cellMass[child];
                mx += cellMass[child] * centreX[child];
                my += cellMass[child] * centreY[child];
            }
        }
        cellMass[cell] = m;
        centreX[cell] = mx / m;
        centreY[cell] = my / m;
    }

    private void findReach(int cell) {
        double farthest = 0;
        for (int k = tree.first(cell); k < tree.end(cell); k++) {
            double dx = masses.x(k) - centreX[cell];
            double dy = masses.y(k) - centreY[cell];
            farthest = Math.max(farthest, dx * dx + dy * dy); // NaN stays
        }
        double radius = Math.sqrt(farthest);
        double extent = Math.abs(centreX[cell]) + Math.abs(centreY[cell]) + radius;
        reach[cell] = extent < LARGEST ? Math.max(radius / theta, SMALLEST) : Double.POSITIVE_INFINITY;
        for (int child = cell + 1; child < tree.past(cell); child = tree.past(child)) {
            reach[cell] =
                    Math.max(reach[cell], reach[child]); // so that what is above a cell without expansions has none
        }
    }

    private boolean expands(int cell) {
        return reach[cell] < Double.POSITIVE_INFINITY;
    }

    private void gather(int cell) {
        if (!expands(cell)) {
            return;
        }
        if (tree.isLeaf(cell)) {
            for (int k = tree.first(cell); k < tree.end(cell); k++) {
                cells.addBody(cell, masses.mass(k), masses.x(k) - centreX[cell], masses.y(k) - centreY[cell]);
            }
        } else {
            for (int child = cell + 1; child < tree.past(cell); child = tree.past(child)) {
                cells.addChild(cell, child, centreX[child] - centreX[cell], centreY[child] - centreY[cell]);
            }
        }
    }

    /** All pairs within a cell; those of bodies are kept for later. */
    private void pullWithin(int cell) {
        if (tree.isLeaf(cell)) {
            bodyPairs += (long) tree.size(cell) * tree.size(cell) / 2;
            return;
        }
        for (int a = cell + 1; a < tree.past(cell); a = tree.past(a)) {
            pullWithin(a);
            for (int b = tree.past(a); b < tree.past(cell); b = tree.past(b)) {
                pullBetween(a, b);
            }
        }
    }

    /** All pairs between two cells; those of bodies are kept for later. */
    private void pullBetween(int a, int b) {
        double dx = centreX[a] - centreX[b];
        double dy = centreY[a] - centreY[b];
        double reachOfBoth = reach[a] + reach[b];
        if (reachOfBoth * reachOfBoth < dx * dx + dy * dy) {
            cells.interact(a, b, dx, dy);
            cellPairs++;
        } else if (tree.isLeaf(a) && tree.isLeaf(b)) {
            near.add(a, b);
            bodyPairs += (long) tree.size(a) * tree.size(b);
        } else if (tree.isLeaf(b) || !tree.isLeaf(a) && reach[a] >= reach[b]) {
            for (int child = a + 1; child < tree.past(a); child = tree.past(child)) {
                pullBetween(child, b);
            }
        } else {
            for (int child = b + 1; child < tree.past(b); child = tree.past(child)) {
                pullBetween(a, child);
            }
        }
    }

    private void passDown(int cell) {
        if (!expands(cell)) {
            return;
        }
        if (tree.isLeaf(cell)) {
            passToBodies(cell);
            return;
        }
        for (int child = cell + 1; child < tree.past(cell); child = tree.past(child)) {
            cells.passDown(cell, child, centreX[child] - centreX[cell], centreY[child] - centreY[cell]);
        }
    }

    /** Lets the bodies of a leaf be pulled by their own and by those of all leaves near by. */
    private void pullNear(int leaf) {
        if (!tree.isLeaf(leaf)) {
            return;
        }
        masses.beginSources();
        masses.addSources(tree.first(leaf), tree.end(leaf));
        for (int k = near.first(leaf); k < near.end(leaf); k++) {
            masses.addSources(tree.first(near.neighbour(k)), tree.end(near.neighbour(k)));
        }
        masses.pullBySources(tree.first(leaf), tree.end(leaf));
    }

    private void passToBodies(int cell) {
        for (int k = tree.first(cell); k < tree.end(cell); k++) {
            cells.passToBody(cell, masses, k, masses.x(k) - centreX[cell], masses.y(k) - centreY[cell]);
        }
    }
}

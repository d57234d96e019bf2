package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.parallel.Work;
import io.github.apsis.engine.spatial.Workspace;
import java.util.Arrays;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;

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
 * <p>The mutual walk of Dehnen 2002 (J. Comput. Phys. 179, 27) with the expansions of {@link CellKernels}, each end worked out
 * for itself ({@link CellWalk}). Both ends of every interaction are served alike, so momentum is conserved to rounding; θ → 0
 * gives the direct sum. On a disc of 10 000 bodies θ = 0.9 errs by 4e-3 in the median and takes 3.2 ms of a slow core, θ = 0.5 by
 * 7e-5 in 7.7 ms; the direct sum takes 84 ms there.
 *
 * <p>Half of the time of a belt of 10 000 at θ = 0.9 goes into pairs of bodies, and a fifth into pairs of cells. 128 pairs of
 * cells side by side, in loops that C2 makes vector code of, took as long as one after the other: 60 ns each.
 *
 * <p>Other rules of opening bought nothing, measured at order 5: θ growing with falling mass (Dehnen's) has the same error in
 * the same time within 5 % on disc and Plummer sphere; opening by an estimate of the error beside the true pull of the
 * target saves a quarter of the body pairs in the sphere and nothing in the disc, and needs pulls that are not yet known.
 * Order 6 needs a quarter less time than order 5 for a median error of 1e-4.
 */
public final class TreeGravity implements ForceLaw {
    /** Bodies from which on a team is asked: with fewer it takes longer to wake than it saves. */
    private static final int MANY = 1000;

    // In pairs of the direct sum, each worked out once from either end: measured on the reference discs.
    private static final double WORK_OF_BODY = 90;
    private static final double WORK_OF_CELLS = 105;
    private static final double WORK_OF_PAIR = 2.3;

    private double theta;
    private final DirectGravity exact;
    private final Team team;
    private final Team alone = Team.ofOne();
    private final MassTree masses;
    private final CellWalk trunk;
    private final CellWalk[] walks; // by member of the team
    private final Work pulling = this::pullBough;
    private final Pulled giving = this::give;
    private @Nullable Bodies bodies; // that the accelerations are given to

    /**
     * Gravity with this opening angle.
     *
     * @param softening of Plummer, length
     * @param theta above 0, where it is the direct sum, and at most 1
     */
    public TreeGravity(double g, double softening, double theta) {
        this(g, softening, theta, Team.ofOne(), new Workspace());
    }

    /** Gravity with this opening angle, worked out by a team. */
    public TreeGravity(double g, double softening, double theta, Team team, Workspace workspace) {
        if (!(theta > 0 && theta <= 1)) {
            throw new IllegalArgumentException("theta must be above 0 and at most 1, was " + theta);
        }
        this.theta = theta;
        this.team = team;
        this.exact = new DirectGravity(g, softening);
        var kernels = new CellKernels(softening);
        var giants = new Giants();
        this.masses = new MassTree(kernels, giants, team, workspace);
        this.trunk = new CellWalk(masses, kernels, giants, g, softening);
        this.walks = new CellWalk[team.size()];
        Arrays.setAll(walks, member -> new CellWalk(masses, kernels, giants, g, softening));
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
    public void apply(Bodies pulled) {
        bodies = pulled;
        compute(pulled, giving);
        bodies = null;
    }

    /** Works the accelerations out and tells them. */
    void compute(Bodies pulled, Pulled to) {
        Team workers = teamFor(pulled);
        masses.plant(pulled, theta, workers);
        trunk.begin(to);
        for (CellWalk walk : walks) {
            walk.begin(to);
        }
        if (pulled.count() > 0) {
            trunk.pullTrunk();
            workers.share(pulling, masses.boughs());
        }
    }

    private Team teamFor(Bodies pulled) {
        return pulled.count() < MANY ? alone : team;
    }

    private void pullBough(int turn, int member) {
        int bough = masses.inTurn(turn);
        walks[member].pullBough(bough, trunk);
    }

    private void give(int slot, double ax, double ay) {
        if (bodies != null) {
            bodies.accelerate(slot, ax, ay);
        }
    }

    /** What the last walk cost, in pairs of the direct sum: counted, so that it is the same on every machine. */
    double work() {
        long cellPairs = trunk.cellPairs();
        long bodyPairs = trunk.bodyPairs();
        for (CellWalk walk : walks) {
            cellPairs += walk.cellPairs();
            bodyPairs += walk.bodyPairs();
        }
        return WORK_OF_BODY * masses.tree().items() + 0.5 * (WORK_OF_CELLS * cellPairs + WORK_OF_PAIR * bodyPairs);
    }

    /** As for {@link DirectGravity#potential}: exact, and n²/2 pairs dear. */
    @Override
    public OptionalDouble potential(Bodies attracting) {
        return exact.potential(attracting);
    }
}

package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.force.GravitySolver.Method;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.spatial.Workspace;
import java.util.OptionalDouble;

/**
 * Newtonian gravity by the cheapest sum that keeps a relative error: the direct one, or a tree as wide open as it may be.
 *
 * <p>Every 64th tick the pull on {@link GravitySample some bodies} is summed exactly. The opening angle, one of a ladder, is
 * narrowed until nine of ten of them are pulled with no larger error than allowed, and widened while the error is below a
 * quarter of that. The work of the tree, counted and not timed, then decides against the direct sum. In between the solver
 * stands, so that the pull depends on positions alone and not on who has asked for it.
 */
public final class AdaptiveGravity implements ForceLaw {
    private static final int FEW = 256; // bodies; no tree is cheaper below
    private static final int TICKS_BETWEEN_LOOKS =
            64; // 64 n exact pairs and one walk: a hundredth of the ticks between
    private static final double SHARE = 0.9; // of the bodies that keep the error
    private static final double SLACK = 0.25; // a step of the ladder makes the error 2 to 3 times larger
    private static final double[] LADDER = {0.9, 0.76, 0.65, 0.55, 0.47, 0.4, 0.34, 0.29, 0.245, 0.21, 0.18, 0.15};
    private static final int FIRST_RUNG = 4;

    private final double allowedError;
    private final DirectGravity direct;
    private final TreeGravity tree;
    private final GravitySample sample;

    private int rung = FIRST_RUNG;
    private boolean useTree = true;
    private double sampledError = Double.NaN; // of the tree at this rung
    private long ticks;
    private int countAtLook;

    /**
     * Gravity with this relative error.
     *
     * @param softening of Plummer, length
     * @param allowedError above 0, below 1
     */
    public AdaptiveGravity(double g, double softening, double allowedError) {
        this(g, softening, allowedError, Team.ofOne(), new Workspace());
    }

    /** Gravity with this relative error, worked out by a team where there is enough of it. */
    public AdaptiveGravity(double g, double softening, double allowedError, Team team, Workspace workspace) {
        if (!(allowedError > 0 && allowedError < 1)) {
            throw new IllegalArgumentException("a force error must be above 0 and below 1, was " + allowedError);
        }
        this.allowedError = allowedError;
        this.direct = new DirectGravity(g, softening, team, workspace);
        this.tree = new TreeGravity(g, softening, LADDER[FIRST_RUNG], team, workspace);
        this.sample = new GravitySample(g, softening);
    }

    /**
     * Looks, now and then, whether another solver should take over. To be called once per tick.
     *
     * @return whether it has, so that accelerations are out of date
     */
    public boolean adapt(Bodies bodies) {
        boolean due = ticks++ % TICKS_BETWEEN_LOOKS == 0;
        if (bodies.count() < FEW || !due && !countHasChanged(bodies)) {
            return false;
        }
        boolean usedTree = useTree;
        double theta = tree.theta();
        decide(bodies);
        return usedTree != useTree || theta != tree.theta();
    }

    private boolean countHasChanged(Bodies bodies) {
        return Math.abs(bodies.count() - countAtLook) > countAtLook / 4;
    }

    @Override
    public void apply(Bodies bodies) {
        if (useTree && bodies.count() >= FEW) {
            tree.apply(bodies);
        } else {
            direct.apply(bodies);
        }
    }

    @Override
    public OptionalDouble potential(Bodies bodies) {
        return direct.potential(bodies);
    }

    /** What is in use for so many bodies. */
    public GravitySolver solver(int bodies) {
        if (bodies < FEW || !useTree) {
            return GravitySolver.of(Method.DIRECT, 0);
        }
        return Double.isNaN(sampledError)
                ? GravitySolver.of(Method.TREE, tree.theta())
                : new GravitySolver(Method.TREE, tree.theta(), OptionalDouble.of(sampledError));
    }

    private void decide(Bodies bodies) {
        countAtLook = bodies.count();
        sample.take(bodies);
        measure(bodies);
        while (sampledError < SLACK * allowedError && rung > 0) {
            rung--;
            measure(bodies);
        }
        while (sampledError > allowedError && rung < LADDER.length - 1 && tree.work() < directWork(bodies)) {
            rung++;
            measure(bodies);
        }
        useTree = sampledError <= allowedError && tree.work() < directWork(bodies);
    }

    private static double directWork(Bodies bodies) {
        return 0.5 * bodies.count() * bodies.count();
    }

    private void measure(Bodies bodies) {
        tree.openAt(LADDER[rung]);
        tree.compute(bodies, sample);
        sample.compare();
        sampledError = sample.error(SHARE);
    }
}

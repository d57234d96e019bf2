package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.spatial.Workspace;
import java.util.Arrays;

/**
 * The true pull on some of the bodies, to hold a solver against: every (n/64)-th body by the direct sum, 64 n pairs of 0.7 ns.
 *
 * <p>The measure is |Δa| / |a| body by body. Where pulls nearly cancel it grows without bound, so its largest value says
 * little; what is kept is the bound that nine of ten bodies meet.
 */
public final class GravitySample implements Pulled {
    private static final int SIZE = 64;
    private static final int TILE = 1024; // sources whose columns stay in the first cache

    private final double g;
    private final NearSources sources;
    private final PointMasses tile = new PointMasses(new Workspace());
    private final PointMasses sample = new PointMasses(new Workspace());
    private final Pulls pulls = new Pulls();
    private final int[] slot = new int[SIZE];
    private final double[] trueAx = new double[SIZE];
    private final double[] trueAy = new double[SIZE];
    private final double[] solverAx = new double[SIZE];
    private final double[] solverAy = new double[SIZE];
    private final double[] error = new double[SIZE];
    private int size;

    public GravitySample(double g, double softening) {
        this.g = g;
        this.sources = new NearSources(softening);
        sample.begin(SIZE);
        tile.begin(TILE);
    }

    /** Sums the pulls of the present positions. */
    public void take(Bodies bodies) {
        size = Math.min(SIZE, bodies.count());
        for (int k = 0; k < size; k++) {
            slot[k] = (int) ((long) k * bodies.count() / size);
            sample.load(k, bodies, slot[k]);
        }
        pulls.begin(0, size);
        for (int start = 0; start < bodies.count(); start += TILE) {
            addTile(bodies, start, Math.min(start + TILE, bodies.count()));
        }
        for (int k = 0; k < size; k++) {
            trueAx[k] = g * pulls.x(k);
            trueAy[k] = g * pulls.y(k);
        }
    }

    private void addTile(Bodies bodies, int start, int stop) {
        for (int i = start; i < stop; i++) {
            tile.load(i - start, bodies, i);
        }
        sources.clear();
        sources.add(tile, 0, stop - start);
        if (NearSources.areOrdinary(tile, 0, stop - start) && NearSources.areOrdinary(sample, 0, size)) {
            sources.pull(sample, 0, size, pulls);
        } else {
            sources.pullWithCare(sample, 0, size, pulls);
        }
    }

    /** Takes what a solver makes of the pull on a body; {@link #compare} looks at those of the sample. */
    @Override
    public void accelerate(int i, double ax, double ay) {
        int k = Arrays.binarySearch(slot, 0, size, i);
        if (k >= 0) {
            solverAx[k] = ax;
            solverAy[k] = ay;
        }
    }

    /** Compares what a solver has said with the truth; {@link #error} tells the result. */
    public void compare() {
        for (int k = 0; k < size; k++) {
            double offX = solverAx[k] - trueAx[k];
            double offY = solverAy[k] - trueAy[k];
            double off = offX * offX + offY * offY;
            double truth = trueAx[k] * trueAx[k] + trueAy[k] * trueAy[k];
            error[k] = off == 0 ? 0 : Math.sqrt(off / truth);
        }
        Arrays.sort(error, 0, size);
    }

    /** The relative error that this share of the sample does not exceed; 0 for no bodies. */
    public double error(double share) {
        return size == 0 ? 0 : error[Math.min(size - 1, (int) (share * size))];
    }
}

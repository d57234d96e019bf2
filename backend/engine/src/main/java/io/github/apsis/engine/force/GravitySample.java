package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.CompensatedSum;
import java.util.Arrays;

/**
 * The true pull on some of the bodies, to hold a solver against: every (n/64)-th body by a compensated direct sum, 64 n pairs.
 *
 * <p>The measure is |Δa| / |a| body by body. Where pulls nearly cancel it grows without bound, so its largest value says
 * little; what is kept is the bound that nine of ten bodies meet.
 */
public final class GravitySample {
    private static final int SIZE = 64;

    private final double g;
    private final double softeningSquared; // length²
    private final int[] slot = new int[SIZE];
    private final double[] trueAx = new double[SIZE];
    private final double[] trueAy = new double[SIZE];
    private final double[] error = new double[SIZE];
    private final CompensatedSum ax = new CompensatedSum();
    private final CompensatedSum ay = new CompensatedSum();
    private int size;

    public GravitySample(double g, double softening) {
        this.g = g;
        this.softeningSquared = softening * softening;
    }

    /** Sums the pulls of the present positions. */
    public void take(Bodies bodies) {
        size = Math.min(SIZE, bodies.count());
        for (int k = 0; k < size; k++) {
            slot[k] = (int) ((long) k * bodies.count() / size);
            sum(bodies, k);
        }
    }

    private void sum(Bodies bodies, int k) {
        ax.clear();
        ay.clear();
        double x = bodies.x(slot[k]);
        double y = bodies.y(slot[k]);
        for (int j = 0; j < bodies.count(); j++) {
            double dx = bodies.x(j) - x;
            double dy = bodies.y(j) - y;
            double d2 = dx * dx + dy * dy + softeningSquared;
            double d3 = d2 * Math.sqrt(d2);
            if (d3 >= Double.MIN_NORMAL && d3 <= Double.MAX_VALUE) {
                ax.add(bodies.mass(j) * (dx / d3));
                ay.add(bodies.mass(j) * (dy / d3));
            }
        }
        trueAx[k] = g * ax.value();
        trueAy[k] = g * ay.value();
    }

    /** Compares accelerations by slot with the truth; {@link #error} tells the result. */
    public void compare(double[] solverAx, double[] solverAy) {
        for (int k = 0; k < size; k++) {
            double offX = solverAx[slot[k]] - trueAx[k];
            double offY = solverAy[slot[k]] - trueAy[k];
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

package io.github.apsis.engine.steering;

import java.util.Arrays;

/**
 * The courses that a ship tries, as shares of its top speed along and across what it prefers: close together where a small
 * change may do, on both sides alike.
 */
final class Candidates {
    /** A speed, and the angles to either side in degrees. */
    private static final double[][] RINGS = {
        {1, 0, 6, 12, 20, 32, 48, 70, 100, 135, 180},
        {0.8, 0, 20},
        {0.6, 0, 35, 70, 120, 180},
        {0.3, 0, 60, 120, 180}
    };

    private static final double[] ALONG;
    private static final double[] ACROSS; // to the left

    static {
        double[] along = new double[64];
        double[] across = new double[64];
        int count = 0;
        for (double[] ring : RINGS) {
            for (int k = 1; k < ring.length; k++) {
                double angle = StrictMath.toRadians(ring[k]);
                double x = ring[0] * StrictMath.cos(angle);
                double y = ring[0] * StrictMath.sin(angle);
                along[count] = x;
                across[count++] = -y; // to the right first: that is what a draw goes to
                if (ring[k] > 0 && ring[k] < 180) {
                    along[count] = x;
                    across[count++] = y;
                }
            }
        }
        ALONG = Arrays.copyOf(along, count);
        ACROSS = Arrays.copyOf(across, count);
    }

    private Candidates() {}

    static int count() {
        return ALONG.length;
    }

    static double along(int c) {
        return ALONG[c];
    }

    static double across(int c) {
        return ACROSS[c];
    }
}

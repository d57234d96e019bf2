package io.github.apsis.benchmarks.contacts;

import java.util.List;

/**
 * The tick of a run: 1/n, as near to a room's as lets every sample fall on a tick to the bit. A sample that no such tick meets
 * is read in a run of its own, whose tick divides its time; so a position error is never one of looking at the wrong moment.
 */
final class SampleTicks {
    /** Ticks per unit of time in a room. */
    static final int ROOM = 150;

    private static final int FEWEST = 100;
    private static final int MOST = 1000;

    private SampleTicks() {}

    /** Ticks per unit of time: the nearest to a room's that meets all of these times, or a room's. */
    static int perUnit(List<Double> times) {
        int best = 0;
        for (int n = FEWEST; n <= MOST; n++) {
            int candidate = n;
            boolean nearer = best == 0 || ratio(n) < ratio(best);
            if (nearer && times.stream().allMatch(time -> meets(time, candidate))) {
                best = n;
            }
        }
        return best == 0 ? ROOM : best;
    }

    private static double ratio(int n) {
        return Math.abs(Math.log((double) n / ROOM));
    }

    /** Whether a time is a whole number of ticks of 1/n, to the last place. */
    static boolean meets(double time, int n) {
        double tick = Math.rint(time * n);
        return tick > 0 && Math.abs(tick / n - time) <= Math.ulp(time);
    }

    /** The longest tick, no longer than this, that divides a time. */
    static double dividing(double time, double longest) {
        return time / Math.ceil(time / longest);
    }
}

package io.github.apsis.benchmarks.accuracy;

/** Lengths of a tick that meet the samples of a case. */
final class Ticks {
    private static final double SAME = 1e-9; // relative; a tick that is off by this moves a body by no more
    private static final double MOST = 1e6;

    private Ticks() {}

    /** The number of ticks until a moment; 0 when it falls between two. */
    static long until(double time, double dt) {
        long tick = Math.round(time / dt);
        return Math.abs(tick * dt - time) <= SAME * Math.max(dt, Math.ulp(time) / SAME) ? tick : 0;
    }

    /** This tick when the end of the case falls on one, or else the nearest that divides the time until the end. */
    static double fitting(double dt, NBodyCase orbit) {
        double end = orbit.end();
        return until(end, dt) > 0 ? dt : end / Math.max(1, Math.round(end / dt));
    }

    /** The longest tick on which all samples fall: their greatest common divisor; the time of the end when there is none. */
    static double longest(NBodyCase orbit) {
        double tick = orbit.end();
        for (Sample sample : orbit.samples()) {
            tick = commonDivisor(tick, sample.time(), orbit.end());
        }
        return tick * MOST < orbit.end() ? orbit.end() : tick;
    }

    /** Euclid's algorithm on doubles: what is below a billionth of the whole counts as nothing. */
    private static double commonDivisor(double a, double b, double whole) {
        double large = a;
        double small = b;
        while (small > SAME * whole) {
            double rest = large % small;
            if (small - rest < SAME * whole) {
                rest = 0;
            }
            large = small;
            small = rest;
        }
        return large;
    }
}

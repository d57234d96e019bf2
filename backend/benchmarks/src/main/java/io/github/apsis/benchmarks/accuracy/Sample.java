package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.engine.WorldSnapshot;

/** Where all bodies truly are at one moment, in the order in which the case lists them. */
record Sample(double time, double[] x, double[] y) {
    /** The largest distance of a body from where it should be, length. NaN when a body is lost. */
    double positionError(WorldSnapshot now) {
        if (now.count() != x.length) {
            return Double.NaN;
        }
        double worst = 0;
        for (int i = 0; i < x.length; i++) {
            worst = Math.max(worst, Math.hypot(now.x(i) - x[i], now.y(i) - y[i]));
        }
        return worst;
    }
}

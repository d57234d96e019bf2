package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.report.Cells;
import java.util.Locale;

/** The largest of many errors, and the one that is worst against its own limit. */
final class Peak {
    private double largest = Double.NaN;
    private double worst;
    private double worstError;
    private double worstLimit;
    private double worstTime;

    /** Takes one more error; NaN is none. */
    void add(double error, double limit, double time) {
        if (Double.isNaN(error)) {
            return;
        }
        largest = Double.isNaN(largest) ? error : Math.max(largest, error);
        double share = error == 0 ? 0 : error / limit;
        if (share > worst) {
            worst = share;
            worstError = error;
            worstLimit = limit;
            worstTime = time;
        }
    }

    /** NaN where there was nothing to compare. */
    double largest() {
        return largest;
    }

    boolean isBeyond() {
        return worst > 1;
    }

    /** {@code position 1.2e-09 > 1.0e-12 at t=2}. */
    String complaint(String what) {
        return String.format(Locale.ROOT, "%s %.1e > %.1e at t=", what, worstError, worstLimit)
                + Cells.plain(worstTime);
    }
}

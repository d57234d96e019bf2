package io.github.apsis.engine.force;

import java.util.Arrays;

/** The coefficients of {@link CellKernels} for all cells of a tree: moments of what is in a cell, and locals of what pulls it. */
final class CellExpansions {
    static final int ORDER = 6;

    /** Moments have orders below ORDER. */
    static final int MOMENTS = ORDER * (ORDER + 1) / 2;

    static final int LOCALS = (ORDER + 1) * (ORDER + 2) / 2;

    double[] moment = new double[16 * MOMENTS];
    double[] local = new double[16 * LOCALS];

    /** Makes room for this many cells, all empty. */
    void begin(int cells) {
        if (cells * LOCALS > local.length) {
            int capacity = cells + cells / 8;
            moment = new double[capacity * MOMENTS];
            local = new double[capacity * LOCALS];
        }
        Arrays.fill(moment, 0, cells * MOMENTS, 0);
        Arrays.fill(local, 0, cells * LOCALS, 0);
    }
}

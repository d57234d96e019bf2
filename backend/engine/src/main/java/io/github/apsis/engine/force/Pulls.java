package io.github.apsis.engine.force;

import java.util.Arrays;

/** What pulls a run of masses, as acceleration / G: scratch memory of one thread. */
final class Pulls {
    private int start;
    private double[] x = new double[64];
    private double[] y = new double[64];

    /** Nothing pulls the masses from the start to before the stop. */
    void begin(int from, int stop) {
        start = from;
        if (stop - from > x.length) {
            x = new double[Math.max(stop - from, 2 * x.length)];
            y = new double[x.length];
        }
        Arrays.fill(x, 0, stop - from, 0);
        Arrays.fill(y, 0, stop - from, 0);
    }

    void add(int mass, double pullX, double pullY) {
        x[mass - start] += pullX;
        y[mass - start] += pullY;
    }

    /** Adds the pulls on a whole run, which stand at the places of its masses. */
    void addAll(double[] pullX, double[] pullY, int from, int stop) {
        for (int k = from; k < stop; k++) {
            x[k - start] += pullX[k];
            y[k - start] += pullY[k];
        }
    }

    /** Nothing pulls one of the masses. */
    void clear(int mass) {
        x[mass - start] = 0;
        y[mass - start] = 0;
    }

    double x(int mass) {
        return x[mass - start];
    }

    double y(int mass) {
        return y[mass - start];
    }
}

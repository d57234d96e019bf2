package io.github.apsis.benchmarks.speed;

import io.github.apsis.engine.math.Rng;
import java.util.Arrays;

/** Circles strewn anywhere in a square, so that some overlap: where they are is all that a broad phase knows. */
record Circles(double[] x, double[] y, double[] r, double side) {
    private static final double DENSITY = 0.2; // share of the area

    /** All of radius 2. */
    static Circles equal(int count, long seed) {
        double[] r = new double[count];
        Arrays.fill(r, 2);
        return strewn(r, new Rng(seed));
    }

    /**
     * Radii from 1 to 100, of a density ∝ r⁻³: every octave covers the same area, as in the belts of asteroids. Nearly all are
     * small, and no single size of cell fits.
     */
    static Circles mixed(int count, long seed) {
        Rng rng = new Rng(seed);
        double[] r = new double[count];
        for (int i = 0; i < count; i++) {
            r[i] = 1 / Math.sqrt(1 - rng.nextDouble() * (1 - 1e-4)); // the inverse of the cumulative density
        }
        return strewn(r, rng);
    }

    private static Circles strewn(double[] r, Rng rng) {
        double area = 0;
        for (double radius : r) {
            area += Math.PI * radius * radius;
        }
        double side = Math.sqrt(area / DENSITY);
        double[] x = new double[r.length];
        double[] y = new double[r.length];
        for (int i = 0; i < r.length; i++) {
            x[i] = rng.between(0, side);
            y[i] = rng.between(0, side);
        }
        return new Circles(x, y, r, side);
    }

    int count() {
        return r.length;
    }

    boolean overlap(int i, int j) {
        double dx = x[j] - x[i];
        double dy = y[j] - y[i];
        double reach = r[i] + r[j];
        return dx * dx + dy * dy < reach * reach;
    }
}

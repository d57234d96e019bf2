package io.github.apsis.engine.force;

import static java.lang.Math.fma;

import java.util.Arrays;

/**
 * The masses near a leaf of a tree, side by side, and their pull on its bodies: scratch memory of one thread.
 *
 * <p>One target after the other, pulled by all sources: 0.7 ns a pair, in vectors but for the sum; short loops over the few
 * targets take 1.2. Two targets to a division, which makes the direct sum faster, takes longer here.
 */
final class NearSources {
    /** Length². Keeps 1/d³ finite where d = 0, and is below the rounding of d² everywhere else in the ordinary range. */
    private static final double FLOOR = 1e-200;

    /** Length; ordinary numbers beyond it differ by 1e-86 or not at all. */
    private static final double SMALLEST = 1e-70;

    /** Length; d² is a number below. */
    private static final double LARGEST = 1e150;

    private final double softeningSquared; // length²
    private int count;
    private double[] x = new double[0];
    private double[] y = new double[0];
    private double[] mass = new double[0];
    private double[] pullX = new double[0];
    private double[] pullY = new double[0];

    NearSources(double softening) {
        this.softeningSquared = softening * softening;
    }

    /** Whether distances between any of a run have cubes, unless they are 0. */
    static boolean areOrdinary(PointMasses masses, int start, int stop) {
        return masses.liesBetween(SMALLEST, LARGEST, start, stop);
    }

    /** Forgets all sources. */
    void clear() {
        count = 0;
    }

    /** Copies a run of masses behind the others. */
    void add(PointMasses masses, int start, int stop) {
        int length = stop - start;
        if (count + length > x.length) {
            int needed = count + length;
            grow(needed + needed / 4);
        }
        System.arraycopy(masses.x, start, x, count, length);
        System.arraycopy(masses.y, start, y, count, length);
        System.arraycopy(masses.mass, start, mass, count, length);
        count += length;
    }

    /** Adds a mass behind the others. */
    void add(double atX, double atY, double m) {
        if (count == x.length) {
            grow(2 * count + 16);
        }
        x[count] = atX;
        y[count] = atY;
        mass[count++] = m;
    }

    private void grow(int capacity) {
        x = Arrays.copyOf(x, capacity);
        y = Arrays.copyOf(y, capacity);
        mass = Arrays.copyOf(mass, capacity);
        pullX = new double[capacity];
        pullY = new double[capacity];
    }

    /** Lets all sources pull a run of masses, which may be among them; their coordinates are ordinary. */
    void pull(PointMasses targets, int start, int stop, Pulls pulls) {
        double e2 = Math.max(softeningSquared, FLOOR);
        for (int j = start; j < stop; j++) {
            computePulls(x, y, mass, pullX, pullY, count, targets.x[j], targets.y[j], e2);
            addSums(pulls, j);
        }
    }

    private static void computePulls(
            double[] sourceX,
            double[] sourceY,
            double[] sourceMass,
            double[] pullX,
            double[] pullY,
            int sources,
            double x,
            double y,
            double e2) {
        for (int k = 0; k < sources; k++) {
            double dx = sourceX[k] - x;
            double dy = sourceY[k] - y;
            double d2 = fma(dx, dx, fma(dy, dy, e2));
            double w = 1 / (d2 * Math.sqrt(d2));
            pullX[k] = sourceMass[k] * (w * dx);
            pullY[k] = sourceMass[k] * (w * dy);
        }
    }

    /** Sums that do not wait for each other. */
    private void addSums(Pulls pulls, int j) {
        double x0 = 0;
        double x1 = 0;
        double x2 = 0;
        double x3 = 0;
        double y0 = 0;
        double y1 = 0;
        double y2 = 0;
        double y3 = 0;
        int k = 0;
        for (; k < count - 3; k += 4) {
            x0 += pullX[k];
            y0 += pullY[k];
            x1 += pullX[k + 1];
            y1 += pullY[k + 1];
            x2 += pullX[k + 2];
            y2 += pullY[k + 2];
            x3 += pullX[k + 3];
            y3 += pullY[k + 3];
        }
        for (; k < count; k++) {
            x0 += pullX[k];
            y0 += pullY[k];
        }
        pulls.add(j, (x0 + x1) + (x2 + x3), (y0 + y1) + (y2 + y3));
    }

    /** The same, without pairs whose distance has no cube: coincident, where a pull has no direction, or beyond 1e102. */
    void pullWithCare(PointMasses targets, int start, int stop, Pulls pulls) {
        for (int j = start; j < stop; j++) {
            for (int k = 0; k < count; k++) {
                double dx = x[k] - targets.x[j];
                double dy = y[k] - targets.y[j];
                double d2 = fma(dx, dx, fma(dy, dy, softeningSquared));
                double d3 = d2 * Math.sqrt(d2);
                boolean isNumber = d3 >= Double.MIN_NORMAL && d3 <= Double.MAX_VALUE;
                double w = isNumber ? 1 / d3 : 0;
                pullX[k] = w == 0 ? 0 : mass[k] * (w * dx);
                pullY[k] = w == 0 ? 0 : mass[k] * (w * dy);
            }
            addSums(pulls, j);
        }
    }
}

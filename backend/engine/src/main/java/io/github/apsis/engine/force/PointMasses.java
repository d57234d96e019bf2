package io.github.apsis.engine.force;

import static java.lang.Math.fma;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.spatial.Quadtree;
import java.util.Arrays;

/**
 * Masses in contiguous columns, and the pulls of runs of them on each other.
 *
 * <p>Loops have no branch, so that C2 makes vector code of them. Long runs of targets take one source after the other, without
 * a sum across the loop: 0.9 ns a pair, although each pair is worked out twice, once from either end; once for both ends took
 * 1.3 ns, and 3.6 with the sum and the reaction in one plain loop (AVX-512, JDK 17 and 25). The short runs of a tree's leaves
 * take one target after the other, pulled by all sources near by: 1.6 ns a pair, against 4.7 by short loops over targets.
 * Every operation is a single IEEE one in a fixed order: the width of vectors does not change a bit.
 */
final class PointMasses {
    private static final int TILE = 512; // bodies whose columns stay in the first cache

    /** Length². Keeps 1/d³ finite where d = 0, and is below the rounding of d² everywhere else in the ordinary range. */
    private static final double FLOOR = 1e-200;

    private static final double SMALLEST = 1e-70; // length; ordinary numbers beyond it differ by 1e-86 or not at all
    private static final double LARGEST = 1e150;

    private final double softeningSquared; // length²
    private int count;
    private boolean ordinary; // no coordinate is so small that d³ underflows, or so large that d² overflows

    private double[] x = new double[16];
    private double[] y = new double[16];
    private double[] mass = new double[16];
    private double[] ax = new double[16]; // acceleration / G
    private double[] ay = new double[16];
    private double[] sumX = new double[16]; // the part of ax from one tile of sources
    private double[] sumY = new double[16];

    private int sources;
    private double[] sourceX = new double[16];
    private double[] sourceY = new double[16];
    private double[] sourceMass = new double[16];

    PointMasses(double softening) {
        this.softeningSquared = softening * softening;
    }

    /** Copies all bodies in the order of their slots. */
    void load(Bodies bodies) {
        begin(bodies.count());
        for (int i = 0; i < count; i++) {
            place(i, bodies.x(i), bodies.y(i), bodies.mass(i));
        }
    }

    /** Copies all bodies in the order of the tree, so that the bodies of a node are a run. */
    void load(Bodies bodies, Quadtree tree) {
        begin(bodies.count());
        for (int k = 0; k < count; k++) {
            int i = tree.item(k);
            place(k, bodies.x(i), bodies.y(i), bodies.mass(i));
        }
    }

    private void begin(int bodies) {
        count = bodies;
        ordinary = true;
        if (count > x.length) {
            int capacity = Math.max(count, 2 * x.length);
            x = new double[capacity];
            y = new double[capacity];
            mass = new double[capacity];
            ax = new double[capacity];
            ay = new double[capacity];
            sumX = new double[capacity];
            sumY = new double[capacity];
            sourceX = new double[capacity];
            sourceY = new double[capacity];
            sourceMass = new double[capacity];
        }
        Arrays.fill(ax, 0, count, 0);
        Arrays.fill(ay, 0, count, 0);
    }

    private void place(int k, double bodyX, double bodyY, double bodyMass) {
        x[k] = bodyX;
        y[k] = bodyY;
        mass[k] = bodyMass;
        ordinary &= isOrdinary(bodyX) && isOrdinary(bodyY);
    }

    private static boolean isOrdinary(double coordinate) {
        double size = Math.abs(coordinate);
        return size == 0 || size > SMALLEST && size < LARGEST;
    }

    double x(int k) {
        return x[k];
    }

    double y(int k) {
        return y[k];
    }

    double mass(int k) {
        return mass[k];
    }

    /** Adds to acceleration / G. */
    void accelerate(int k, double dax, double day) {
        ax[k] += dax;
        ay[k] += day;
    }

    /** Hands the accelerations to the bodies in the order of their slots. */
    void giveTo(Bodies bodies, double g) {
        for (int i = 0; i < count; i++) {
            bodies.accelerate(i, g * ax[i], g * ay[i]);
        }
    }

    /** Hands the accelerations to the bodies in the order of the tree. */
    void giveTo(Bodies bodies, Quadtree tree, double g) {
        for (int k = 0; k < count; k++) {
            bodies.accelerate(tree.item(k), g * ax[k], g * ay[k]);
        }
    }

    /** Writes the accelerations by the slots of the bodies. */
    void copyTo(double[] toX, double[] toY, Quadtree tree, double g) {
        for (int k = 0; k < count; k++) {
            toX[tree.item(k)] = g * ax[k];
            toY[tree.item(k)] = g * ay[k];
        }
    }

    /** Lets every pair within a run pull each other. */
    void pullWithin(int start, int stop) {
        // A body does not pull itself, as no body pulls another on the same spot.
        for (int left = start; left < stop; left += TILE) {
            for (int first = start; first < stop; first += TILE) {
                pullTile(left, Math.min(left + TILE, stop), first, Math.min(first + TILE, stop));
            }
        }
    }

    private void pullTile(int start, int stop, int sourceStart, int sourceStop) {
        Arrays.fill(sumX, start, stop, 0);
        Arrays.fill(sumY, start, stop, 0);
        double e2 = Math.max(softeningSquared, FLOOR);
        for (int i = sourceStart; i < sourceStop; i++) {
            if (ordinary) {
                addPulls(x, y, sumX, sumY, start, stop, x[i], y[i], mass[i], e2);
            } else {
                addPullsWithCare(start, stop, i);
            }
        }
        add(ax, sumX, start, stop);
        add(ay, sumY, start, stop);
    }

    private static void addPulls(
            double[] x,
            double[] y,
            double[] sumX,
            double[] sumY,
            int start,
            int stop,
            double sourceX,
            double sourceY,
            double sourceMass,
            double e2) {
        for (int j = start; j < stop; j++) {
            double dx = sourceX - x[j];
            double dy = sourceY - y[j];
            double d2 = fma(dx, dx, fma(dy, dy, e2));
            double w = 1 / (d2 * Math.sqrt(d2));
            sumX[j] = fma(sourceMass, w * dx, sumX[j]);
            sumY[j] = fma(sourceMass, w * dy, sumY[j]);
        }
    }

    /** Forgets all sources. */
    void beginSources() {
        sources = 0;
    }

    /** Copies a run of bodies behind the other sources. */
    void addSources(int start, int stop) {
        int length = stop - start;
        System.arraycopy(x, start, sourceX, sources, length);
        System.arraycopy(y, start, sourceY, sources, length);
        System.arraycopy(mass, start, sourceMass, sources, length);
        sources += length;
    }

    /** Lets all sources pull a run of bodies; they may be among the sources. */
    void pullBySources(int start, int stop) {
        double e2 = Math.max(softeningSquared, FLOOR);
        for (int j = start; j < stop; j++) {
            if (ordinary) {
                computePulls(sourceX, sourceY, sourceMass, sumX, sumY, sources, x[j], y[j], e2);
            } else {
                computePullsWithCare(j);
            }
            ax[j] += sum(sumX, sources);
            ay[j] += sum(sumY, sources);
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

    private static double sum(double[] terms, int count) {
        double s0 = 0;
        double s1 = 0;
        double s2 = 0;
        double s3 = 0;
        int k = 0;
        for (; k < count - 3; k += 4) {
            s0 += terms[k];
            s1 += terms[k + 1];
            s2 += terms[k + 2];
            s3 += terms[k + 3];
        }
        for (; k < count; k++) {
            s0 += terms[k];
        }
        return (s0 + s1) + (s2 + s3);
    }

    private void computePullsWithCare(int j) {
        for (int k = 0; k < sources; k++) {
            double dx = sourceX[k] - x[j];
            double dy = sourceY[k] - y[j];
            double d2 = fma(dx, dx, fma(dy, dy, softeningSquared));
            double d3 = d2 * Math.sqrt(d2);
            double w = d3 >= Double.MIN_NORMAL && d3 <= Double.MAX_VALUE ? 1 / d3 : 0;
            sumX[k] = w == 0 ? 0 : sourceMass[k] * (w * dx);
            sumY[k] = w == 0 ? 0 : sourceMass[k] * (w * dy);
        }
    }

    /** The same, without pairs whose distance has no cube: coincident, where a pull has no direction, or beyond 1e102. */
    private void addPullsWithCare(int start, int stop, int source) {
        for (int j = start; j < stop; j++) {
            double dx = x[source] - x[j];
            double dy = y[source] - y[j];
            double d2 = fma(dx, dx, fma(dy, dy, softeningSquared));
            double d3 = d2 * Math.sqrt(d2);
            if (d3 >= Double.MIN_NORMAL && d3 <= Double.MAX_VALUE) {
                double w = 1 / d3;
                sumX[j] = fma(mass[source], w * dx, sumX[j]);
                sumY[j] = fma(mass[source], w * dy, sumY[j]);
            }
        }
    }

    private static void add(double[] sum, double[] part, int start, int stop) {
        for (int j = start; j < stop; j++) {
            sum[j] += part[j];
        }
    }
}

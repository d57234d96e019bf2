package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.spatial.Quadtree;

/** Masses in contiguous columns, and what pulls them: what the loops of a gravity solver read and write. */
final class PointMasses {
    private int count;
    double[] x = new double[16];
    double[] y = new double[16];
    double[] mass = new double[16];
    double[] ax = new double[16]; // acceleration / G
    double[] ay = new double[16];

    /** Makes room for this many masses. */
    void begin(int masses) {
        count = masses;
        if (count > x.length) {
            int capacity = Math.max(count, x.length + x.length / 8);
            x = new double[capacity];
            y = new double[capacity];
            mass = new double[capacity];
            ax = new double[capacity];
            ay = new double[capacity];
        }
    }

    int count() {
        return count;
    }

    /** Copies bodies in the order of their slots, from the start to before the stop; nothing pulls them yet. */
    void load(Bodies bodies, int start, int stop) {
        for (int i = start; i < stop; i++) {
            load(i, bodies, i);
        }
    }

    /** Copies bodies in the order of the tree, so that those of a node are a run, with their masses in the tree. */
    void load(Bodies bodies, Quadtree tree, Giants giants, int start, int stop) {
        for (int k = start; k < stop; k++) {
            load(k, bodies, tree.item(k));
            mass[k] = giants.massInTree(mass[k]);
        }
    }

    /** Copies one body, which nothing pulls yet. */
    void load(int k, Bodies bodies, int slot) {
        x[k] = bodies.x(slot);
        y[k] = bodies.y(slot);
        mass[k] = bodies.mass(slot);
        ax[k] = 0;
        ay[k] = 0;
    }

    /** Whether every coordinate of a run is 0 or between these in size. */
    boolean liesBetween(double smallest, double largest, int start, int stop) {
        boolean within = true;
        for (int k = start; k < stop; k++) {
            within &= isBetween(Math.abs(x[k]), smallest, largest) && isBetween(Math.abs(y[k]), smallest, largest);
        }
        return within;
    }

    private static boolean isBetween(double size, double smallest, double largest) {
        return size == 0 || size > smallest && size < largest;
    }

    /** Adds to acceleration / G. */
    void accelerate(int k, double dax, double day) {
        ax[k] += dax;
        ay[k] += day;
    }

    /** Hands the accelerations to the bodies in the order of their slots. */
    void giveTo(Bodies bodies, double g, int start, int stop) {
        for (int i = start; i < stop; i++) {
            bodies.accelerate(i, g * ax[i], g * ay[i]);
        }
    }

    /** Hands the accelerations to the bodies in the order of the tree. */
    void giveTo(Bodies bodies, Quadtree tree, double g, int start, int stop) {
        for (int k = start; k < stop; k++) {
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
}

package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.spatial.Quadtree;
import io.github.apsis.engine.spatial.Workspace;

/** Masses in contiguous columns: what the loops of a gravity solver read. */
final class PointMasses {
    private static final double[] NONE = new double[0];

    private final Workspace workspace;
    private int count;
    double[] x = NONE;
    double[] y = NONE;
    double[] mass = NONE;

    /** Masses in the first three columns of a workspace. */
    PointMasses(Workspace workspace) {
        this.workspace = workspace;
    }

    /** Makes room for this many masses. */
    void begin(int masses) {
        count = masses;
        x = workspace.doubles(0, count);
        y = workspace.doubles(1, count);
        mass = workspace.doubles(2, count);
    }

    int count() {
        return count;
    }

    /** Copies bodies in the order of their slots, from the start to before the stop. */
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

    /** Copies one body. */
    void load(int k, Bodies bodies, int slot) {
        x[k] = bodies.x(slot);
        y[k] = bodies.y(slot);
        mass[k] = bodies.mass(slot);
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
}

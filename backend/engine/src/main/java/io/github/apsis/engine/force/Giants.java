package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.spatial.Quadtree;

/**
 * The few bodies that outweigh a share of everything, such as the planet of a belt: they pull and are pulled body by body, and
 * weigh nothing in the tree.
 *
 * <p>Nearly all of the force in such a world is theirs, and a cell as wide as its angle allows takes it as a polynomial that errs
 * at its rim by θ⁷. In a belt of 10 000 around a planet the whole force erred by up to 1e-2 at θ = 0.9, from one tick to another
 * more or less; it errs by 5e-5 without the planet in the tree. There are fewer than {@value #MOST}, so this is a pass over the
 * bodies for each.
 */
final class Giants {
    private static final int MOST = 16;

    private final double softeningSquared; // length²
    private double heaviest; // of the others
    private int count;
    private final int[] slot = new int[MOST];
    private final double[] x = new double[MOST];
    private final double[] y = new double[MOST];
    private final double[] mass = new double[MOST];
    private final double[] ax = new double[MOST]; // acceleration / G by all bodies
    private final double[] ay = new double[MOST];

    Giants(double softening) {
        this.softeningSquared = softening * softening;
    }

    /** Looks for them, and lets everything pull them. */
    void find(Bodies bodies) {
        double all = 0;
        for (int i = 0; i < bodies.count(); i++) {
            all += bodies.mass(i);
        }
        heaviest = all / MOST;
        count = 0;
        for (int i = 0; i < bodies.count() && count < MOST; i++) {
            if (bodies.mass(i) > heaviest) {
                slot[count] = i;
                x[count] = bodies.x(i);
                y[count] = bodies.y(i);
                mass[count++] = bodies.mass(i);
            }
        }
        for (int k = 0; k < count; k++) {
            pullGiant(bodies, k);
        }
    }

    private void pullGiant(Bodies bodies, int k) {
        double sumX = 0;
        double sumY = 0;
        for (int i = 0; i < bodies.count(); i++) {
            double dx = bodies.x(i) - x[k];
            double dy = bodies.y(i) - y[k];
            double w = i == slot[k] ? 0 : inverseCube(dx, dy);
            if (w > 0) {
                sumX += bodies.mass(i) * (w * dx);
                sumY += bodies.mass(i) * (w * dy);
            }
        }
        ax[k] = sumX;
        ay[k] = sumY;
    }

    /** 1/d³, and 0 where that is no number: coincident, where a pull has no direction, or beyond 1e102. */
    private double inverseCube(double dx, double dy) {
        double d2 = dx * dx + dy * dy + softeningSquared;
        double d3 = d2 * Math.sqrt(d2);
        return d3 >= Double.MIN_NORMAL && d3 <= Double.MAX_VALUE ? 1 / d3 : 0;
    }

    /** What a body weighs in the tree. */
    double massInTree(double bodyMass) {
        return bodyMass > heaviest ? 0 : bodyMass;
    }

    /** Adds their pull to that of the tree, for a run of bodies. */
    void pull(PointMasses bodies, Quadtree tree, int start, int stop, Pulls pulls) {
        for (int g = 0; g < count; g++) {
            for (int k = start; k < stop; k++) {
                double dx = x[g] - bodies.x[k];
                double dy = y[g] - bodies.y[k];
                double w = inverseCube(dx, dy);
                if (w > 0) {
                    pulls.add(k, mass[g] * (w * dx), mass[g] * (w * dy));
                }
            }
        }
        for (int k = start; k < stop && count > 0; k++) {
            for (int g = 0; g < count; g++) {
                if (tree.item(k) == slot[g]) {
                    pulls.set(k, ax[g], ay[g]);
                }
            }
        }
    }
}

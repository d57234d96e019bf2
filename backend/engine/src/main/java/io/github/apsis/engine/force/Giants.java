package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;

/**
 * The few bodies that outweigh a share of everything, such as the planet of a belt: they pull and are pulled body by body, and
 * weigh nothing in the tree.
 *
 * <p>Nearly all of the force in such a world is theirs, and a cell as wide as its angle allows takes it as a polynomial that errs
 * at its rim by θ⁷. In a belt of 10 000 around a planet the whole force erred by up to 1e-2 at θ = 0.9, from one tick to another
 * more or less; it errs by 5e-5 without the planet in the tree. There are fewer than {@value #MOST}: every leaf has them among the
 * {@link NearSources}, and they have all bodies.
 */
final class Giants {
    private static final int MOST = 16;

    private double heaviest; // of the others
    private int count;
    private final int[] slot = new int[MOST];
    private final double[] x = new double[MOST];
    private final double[] y = new double[MOST];
    private final double[] mass = new double[MOST];

    /** Looks for them. */
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
    }

    /** Whether the body in a slot is one. */
    boolean contain(int body) {
        for (int k = 0; k < count; k++) {
            if (slot[k] == body) {
                return true;
            }
        }
        return false;
    }

    /** What a body weighs in the tree. */
    double massInTree(double bodyMass) {
        return bodyMass > heaviest ? 0 : bodyMass;
    }

    /** Adds them to sources that pull body by body. */
    void addTo(NearSources sources) {
        for (int k = 0; k < count; k++) {
            sources.add(x[k], y[k], mass[k]);
        }
    }
}

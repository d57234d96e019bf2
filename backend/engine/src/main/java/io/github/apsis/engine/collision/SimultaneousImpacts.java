package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import java.util.Arrays;

/**
 * Contacts that begin in the same moment and share bodies: a ball that hits two at once, a row that is struck from both ends.
 *
 * <p>All impulses together leave each contact with e times the speed with which it closed (Newton's restitution in Moreau's
 * form, as one linear complementarity problem), so the order of bodies does not matter and mirror images stay mirror images.
 * They are then scaled to Σ (1 + e) λ c / λ·Aλ, which is 1 but for rounding: with it, no impact gains energy, and for e = 1 none
 * loses any.
 */
final class SimultaneousImpacts {
    private static final double TOLERANCE = 1e-15;
    private static final int WORK = 300_000; // contacts times rounds
    private static final int FEWEST_ROUNDS = 30;

    private final ImpulseSolver solver = new ImpulseSolver();
    private int size;
    private int[] first = new int[8];
    private int[] second = new int[8];
    private double[] normalX = new double[8];
    private double[] normalY = new double[8];
    private double[] closingSpeed = new double[8];
    private double[] bounce = new double[8]; // 1 + e
    private double work; // mass · length² / time²
    private int bodies;
    private int[] partners = new int[16]; // contacts of each body in this moment, where there is more than one

    void clear(int count) {
        bodies = count;
        for (int k = 0; k < size && size > 1; k++) {
            partners[first[k]] = 0;
            if (second[k] >= 0) {
                partners[second[k]] = 0;
            }
        }
        size = 0;
    }

    /** Adds a contact between bodies, or of a body with a wall as a negative number. */
    void add(int a, int b) {
        if (size == first.length) {
            first = Arrays.copyOf(first, 2 * size);
            second = Arrays.copyOf(second, 2 * size);
            normalX = Arrays.copyOf(normalX, 2 * size);
            normalY = Arrays.copyOf(normalY, 2 * size);
            closingSpeed = Arrays.copyOf(closingSpeed, 2 * size);
            bounce = Arrays.copyOf(bounce, 2 * size);
        }
        first[size] = a;
        second[size] = b;
        size++;
        if (size == 2) {
            if (bodies > partners.length) {
                partners = new int[Math.max(bodies, partners.length + partners.length / 8)];
            }
            count(0);
        }
        if (size > 1) {
            count(size - 1);
        }
    }

    private void count(int k) {
        partners[first[k]]++;
        if (second[k] >= 0) {
            partners[second[k]]++;
        }
    }

    int size() {
        return size;
    }

    int first(int k) {
        return first[k];
    }

    int second(int k) {
        return second[k];
    }

    /** Whether a body is in one of these contacts. */
    boolean touches(int i) {
        return i >= 0 && (size == 1 ? i == first[0] || i == second[0] : partners[i] > 0);
    }

    /** Tells how a contact closes in this moment. */
    void measured(int k, Approach approach, double e) {
        normalX[k] = approach.contact().nx;
        normalY[k] = approach.contact().ny;
        closingSpeed[k] = approach.closingSpeed();
        bounce[k] = 1 + e;
    }

    /** Finds all impulses: {@link #impulse}, {@link #pushX}, {@link #pushY}. */
    void solve(Bodies bodies) {
        solver.begin(size, bodies);
        for (int k = 0; k < size; k++) {
            solver.add(first[k], second[k], normalX[k], normalY[k], 0);
            solver.measured(k, -bounce[k] * closingSpeed[k]);
        }
        solver.solve(TOLERANCE, 0, Math.max(FEWEST_ROUNDS, WORK / size));
        double wanted = 0;
        for (int k = 0; k < size; k++) {
            wanted += bounce[k] * closingSpeed[k] * solver.impulse(k);
        }
        double factor = wanted / solver.selfWork();
        if (factor > 0 && factor < Double.POSITIVE_INFINITY) {
            solver.scaleBy(factor);
        }
        work = 0.5 * solver.selfWork();
        for (int k = 0; k < size; k++) {
            work -= solver.impulse(k) * closingSpeed[k];
        }
        solver.push();
    }

    double impulse(int k) {
        return solver.impulse(k);
    }

    /** The energy that all impulses together add, negative or zero. */
    double work() {
        return work;
    }

    double normalX(int k) {
        return normalX[k];
    }

    double normalY(int k) {
        return normalY[k];
    }

    double closingSpeed(int k) {
        return closingSpeed[k];
    }

    /** 1 + e. */
    double bounce(int k) {
        return bounce[k];
    }

    /** One more than the highest number: the bodies in these contacts are numbered from 1 on, in the order of the contacts. */
    int numbers() {
        return solver.numbers();
    }

    /** The body of a number. */
    int slot(int number) {
        return solver.slot(number);
    }

    /** The inverse mass that a body has in these impacts. */
    double inverseMass(int number) {
        return solver.inverseMass(number);
    }

    /** The change of velocity of a body. */
    double pushX(int number) {
        return solver.pushX(number);
    }

    double pushY(int number) {
        return solver.pushY(number);
    }
}

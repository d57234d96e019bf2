package io.github.apsis.engine.integration;

import io.github.apsis.engine.body.Ledger;
import java.util.Arrays;

/**
 * What comes into a step from outside: fields and thrust, which are constant, and what holds the fixed bodies against gravity,
 * which is a series.
 *
 * <pre>
 *   J = Σ F t − Σ ∫ F_held dt        M = Σ (∫ x dt F_y − ∫ y dt F_x) − ∫ M_held dt
 * </pre>
 */
final class OutsideImpulses {
    private final int stride;
    private int count;
    private boolean acts;
    private double[] force = new double[0]; // of field and thrust on each body, x and y
    private final double[] heldX; // coefficients of the force of gravity on all fixed bodies together
    private final double[] heldY;
    private final double[] heldMoment; // and of its moment about the origin

    /**
     * @param stride from one body's coefficients to the next one's
     */
    OutsideImpulses(int stride) {
        this.stride = stride;
        heldX = new double[stride];
        heldY = new double[stride];
        heldMoment = new double[stride];
    }

    void clear(int bodies) {
        count = bodies;
        acts = false;
        if (2 * bodies > force.length) {
            force = new double[2 * bodies];
        }
        Arrays.fill(force, 0);
        Arrays.fill(heldX, 0);
        Arrays.fill(heldY, 0);
        Arrays.fill(heldMoment, 0);
    }

    /** A constant force on a body. */
    void push(int i, double fx, double fy) {
        force[2 * i] = fx;
        force[2 * i + 1] = fy;
        acts |= fx != 0 || fy != 0;
    }

    /** Coefficient k of the force that a fixed body at (x, y) is held against. */
    void hold(int k, double fx, double fy, double x, double y) {
        heldX[k] += fx;
        heldY[k] += fy;
        heldMoment[k] += x * fy - y * fx;
        acts = true;
    }

    /** Books impulse and moment between two times of the step, with the coefficients of all positions in units of time. */
    void book(Ledger ledger, double[] x, double[] y, double from, double to, double unit) {
        if (!acts) {
            return;
        }
        double t0 = from / unit;
        double t1 = to / unit;
        double px = -integral(heldX, 0, t0, t1) / unit;
        double py = -integral(heldY, 0, t0, t1) / unit;
        double moment = -integral(heldMoment, 0, t0, t1) / unit;
        for (int i = 0; i < count; i++) {
            double fx = force[2 * i];
            double fy = force[2 * i + 1];
            if (fx != 0 || fy != 0) {
                px += fx * (to - from);
                py += fy * (to - from);
                moment += unit * (integral(x, i * stride, t0, t1) * fy - integral(y, i * stride, t0, t1) * fx);
            }
        }
        ledger.bookMomentum(px, py);
        ledger.bookAngularMomentum(moment);
    }

    private double integral(double[] coefficients, int at, double t0, double t1) {
        return integral(coefficients, at, t1) - integral(coefficients, at, t0);
    }

    private double integral(double[] coefficients, int at, double t) {
        double integral = 0;
        for (int k = stride - 1; k >= 0; k--) {
            integral = integral * t + coefficients[at + k] / (k + 1);
        }
        return integral * t;
    }
}

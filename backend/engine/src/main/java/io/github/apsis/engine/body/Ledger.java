package io.github.apsis.engine.body;

import io.github.apsis.engine.math.CompensatedSum;

/**
 * What is not conserved by right, booked as it happens: the energy, momentum and angular momentum that engines, contacts,
 * walls and outer fields put into the free bodies. What a world did beyond these books is the error of its numerics.
 */
public final class Ledger {
    private final CompensatedSum energy = new CompensatedSum();
    private final CompensatedSum momentumX = new CompensatedSum();
    private final CompensatedSum momentumY = new CompensatedSum();
    private final CompensatedSum angularMomentum = new CompensatedSum();

    /** Books work done on the bodies; negative when energy left. */
    public void bookEnergy(double work) {
        energy.add(work);
    }

    /** Books an impulse from outside, a wall, a fixed body, an engine, on a body at (x, y), and its moment. */
    public void bookImpulse(double px, double py, double x, double y) {
        bookMomentum(px, py);
        bookAngularMomentum(x * py - y * px);
    }

    /** Books an impulse from outside without its moment, which is booked apart. */
    public void bookMomentum(double px, double py) {
        momentumX.add(px);
        momentumY.add(py);
    }

    /** Books the moment about the origin of impulses from outside, or of a body that was put elsewhere. */
    public void bookAngularMomentum(double moment) {
        angularMomentum.add(moment);
    }

    /** Σ work since the world began, mass · length² / time². */
    public double energy() {
        return energy.value();
    }

    public double momentumX() {
        return momentumX.value();
    }

    public double momentumY() {
        return momentumY.value();
    }

    /** About the origin, mass · length² / time. */
    public double angularMomentum() {
        return angularMomentum.value();
    }
}

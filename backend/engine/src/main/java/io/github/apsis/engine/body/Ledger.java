package io.github.apsis.engine.body;

import io.github.apsis.engine.math.CompensatedSum;

/**
 * What is not conserved by right, booked as it happens: the energy and momentum that engines, contacts and walls put into
 * the free bodies. What a world's energy did beyond these books is the error of its numerics.
 */
public final class Ledger {
    private final CompensatedSum energy = new CompensatedSum();
    private final CompensatedSum momentumX = new CompensatedSum();
    private final CompensatedSum momentumY = new CompensatedSum();

    /** Books work done on the bodies; negative when energy left. */
    public void bookEnergy(double work) {
        energy.add(work);
    }

    /** Books an impulse from outside: a wall, a fixed body, an engine. */
    public void bookMomentum(double px, double py) {
        momentumX.add(px);
        momentumY.add(py);
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
}

package io.github.apsis.engine.integration;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.force.Forces;

/**
 * The fourth-order triple jump of Yoshida (1990, Phys. Lett. A 150, 262): three leapfrogs, the middle one backwards.
 *
 * <pre>
 *   S(w dt) · S((1 − 2w) dt) · S(w dt)     w = 1/(2 − 2^(1/3)),  S = kick-drift-kick
 * </pre>
 *
 * <p>Order 4, symplectic and time-reversible. Three evaluations of the forces a tick; the backward step makes its error
 * constant large, so {@link Pefrl} is the better choice at the same order.
 */
public final class Yoshida4 implements Integrator {
    private static final double W = 1.351207191959657634047687808971460826922; // 1/(2 − 2^(1/3))
    private static final double MIDDLE = 1 - 2 * W;

    @Override
    public void advance(Bodies bodies, Forces forces, double dt) {
        forces.ensureCurrent(bodies);
        bodies.kick(W * dt / 2);
        bodies.drift(W * dt);
        forces.evaluate(bodies);
        bodies.kick((W + MIDDLE) * dt / 2);
        bodies.drift(MIDDLE * dt);
        forces.evaluate(bodies);
        bodies.kick((W + MIDDLE) * dt / 2);
        bodies.drift(W * dt);
        forces.evaluate(bodies);
        bodies.kick(W * dt / 2);
    }
}

package io.github.apsis.engine.integration;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.force.Forces;

/**
 * Velocity Verlet, the leapfrog in its kick-drift-kick form (Verlet 1967, Phys. Rev. 159, 98; Swope et al. 1982,
 * J. Chem. Phys. 76, 637).
 *
 * <pre>
 *   v += a(x) dt/2     x += v dt     v += a(x) dt/2
 * </pre>
 *
 * <p>Order 2, symplectic and time-reversible: the energy error oscillates and does not grow. One evaluation of the forces a
 * tick, since the last one serves the next tick's first kick.
 */
public final class VelocityVerlet implements PathIntegrator {
    @Override
    public void move(Bodies bodies, Forces forces, double dt) {
        forces.ensureCurrent(bodies);
        bodies.kick(dt / 2);
        bodies.drift(dt);
    }

    @Override
    public void finish(Bodies bodies, Forces forces, double dt) {
        forces.evaluate(bodies);
        bodies.kick(dt / 2);
    }
}

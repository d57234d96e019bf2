package io.github.apsis.engine.integration;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.force.Forces;

/**
 * Semi-implicit (symplectic) Euler: velocity first, then position with the new velocity.
 *
 * <pre>
 *   v += a(x) dt     x += v dt
 * </pre>
 *
 * <p>Order 1, symplectic: the energy error stays bounded, at a size that falls only like dt. As dear as Verlet, so of use
 * for comparison and for scenes without forces.
 */
public final class SemiImplicitEuler implements PathIntegrator {
    @Override
    public void move(Bodies bodies, Forces forces, double dt) {
        forces.ensureCurrent(bodies);
        bodies.kick(dt);
        bodies.drift(dt);
    }

    @Override
    public void finish(Bodies bodies, Forces forces, double dt) {
        // Positions and velocities already belong to the end of the tick.
    }
}

package io.github.apsis.engine.integration;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.force.Forces;

/** How positions and velocities advance by one tick. A new integrator is one new class. */
public interface Integrator {
    /** Advances all bodies by dt; then positions and velocities belong to the same time. */
    void advance(Bodies bodies, Forces forces, double dt);
}

package io.github.apsis.engine.integration;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.force.Forces;

/**
 * An integrator in two halves, so that contacts can act on the path between them.
 *
 * <p>After {@link #move} every body stands at the end of its path, its velocity is the mean velocity of that path, and its
 * acceleration is the one the path was drawn with. After {@link #finish} positions and velocities belong to the same time.
 */
public interface PathIntegrator extends Integrator {
    /** Draws the path of one tick. */
    void move(Bodies bodies, Forces forces, double dt);

    /** Completes the velocities at the positions that are now final. */
    void finish(Bodies bodies, Forces forces, double dt);

    @Override
    default void advance(Bodies bodies, Forces forces, double dt) {
        move(bodies, forces, dt);
        finish(bodies, forces, dt);
    }
}

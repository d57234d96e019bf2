package io.github.apsis.engine.integration;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.force.Forces;

/**
 * Seventeen leapfrogs whose errors cancel up to order 8, with the coefficients of Kahan and Li (1997, Math. Comp. 66, 1089,
 * scheme s17odr8a).
 *
 * <pre>
 *   S(w1 dt) · S(w2 dt) · … · S(w9 dt) · … · S(w2 dt) · S(w1 dt)     S = drift-kick-drift,  2(w1 + … + w8) + w9 = 1
 * </pre>
 *
 * <p>Order 8, symplectic and time-reversible. Seventeen evaluations of the forces a tick, so that it takes ticks which are
 * long. Its error is soon below rounding, so positions and velocities are summed with compensation. With kick-drift-kick for S
 * it was 6 to 14 times larger on figure-eight, Kepler and triple orbits.
 */
public final class Symplectic8 implements Integrator {
    private static final double[] W = {
        0.13020248308889008087881763,
        0.56116298177510838456196441,
        -0.38947496264484728640807860,
        0.15884190655515560089621075,
        -0.39590389413323757733623154,
        0.18453964097831570709183254,
        0.25837438768632204729397911,
        0.29501172360931029887096624,
        -0.60550853383003451169892108
    };

    private static final int STAGES = 2 * W.length - 1;

    @Override
    public void advance(Bodies bodies, Forces forces, double dt) {
        double before = 0;
        for (int stage = 0; stage < STAGES; stage++) {
            bodies.driftCompensated((before + weight(stage)) * dt / 2);
            forces.evaluate(bodies);
            bodies.kickCompensated(weight(stage) * dt);
            before = weight(stage);
        }
        bodies.driftCompensated(before * dt / 2);
    }

    private static double weight(int stage) {
        return W[Math.min(stage, STAGES - 1 - stage)];
    }
}

package io.github.apsis.engine.integration;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.force.Forces;

/**
 * Newton's gravity by Taylor series of high order, with steps as long as the motion allows: a step spans many ticks where
 * bodies are far apart, and a tick many steps where they pass close.
 *
 * <p>The length of a step is set before it is taken, from the last two terms of {@link GravitySeries}, for the pair that needs
 * the shortest: each separation is kept to the tolerance relative to itself, wherever the world stands and however fast it
 * moves. Ticks inside a step are read off its polynomial. Positions, velocities and the accelerations are carried in pairs of
 * doubles, so that rounding grows like a random walk (Brouwer 1937, AJ 46, 149) that starts below the last bit.
 *
 * <p>It knows gravity, uniform fields and thrust, which is constant through a tick. Two points that fall into each other
 * bounce, see {@link GravitySeries#bounceClosest}. A tick that needs more than {@value #MOST_STEPS} steps is not finished: the
 * time that is left of it is lost and counted.
 */
public final class AdaptiveTaylor implements Integrator {
    /** The most bodies it is made for: each pair keeps its series, 650 bytes and 0.4 µs a step. */
    public static final int MOST_BODIES = 256;

    private static final int MOST_STEPS = 50_000; // of one tick

    private final TaylorStep step;
    private final ThrustWork thrust = new ThrustWork();

    private long revision = -1;
    private double elapsed; // from the moment of the step to the present
    private double elapsedLow;
    private double lostTime;

    public AdaptiveTaylor(TaylorStep step) {
        this.step = step;
    }

    @Override
    public void advance(Bodies bodies, Forces forces, double dt) {
        boolean ships = bodies.ships().length > 0;
        if (bodies.revision() != revision || ships) {
            elapsed = 0;
            elapsedLow = 0;
            step.begin(bodies, dt);
        }
        if (ships) {
            thrust.begin(bodies);
        }
        double target = elapsed + dt;
        double targetLow = elapsedLow + ((elapsed - target) + dt);
        int steps = 0;
        while (target > step.length()) {
            double length = step.length();
            step.place(bodies, length, 0);
            if (steps++ == MOST_STEPS) {
                lostTime += target - length;
                target = 0;
                targetLow = 0;
                step.begin(bodies, dt);
                break;
            }
            double left = target - length;
            targetLow += (target - left) - length;
            target = left;
            step.begin(bodies, dt);
        }
        step.place(bodies, target, targetLow);
        elapsed = target;
        elapsedLow = targetLow;
        if (ships) {
            thrust.book(bodies);
        }
        revision = bodies.revision();
    }

    /** How often two points have fallen into each other and were turned round. */
    public long bounces() {
        return step.bounces();
    }

    /** The time that was lost in ticks which needed too many steps. */
    public double lostTime() {
        return lostTime;
    }
}

package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;

/**
 * Seek and arrive: towards the target at full speed, slower inside the slowing radius, so that the ship stops there
 * (Reynolds 1999, "Steering behaviors for autonomous characters").
 *
 * <pre>
 *   speed = min(v_max, v_max · d / slowing radius, √(2 · 0.8 · a_max · d))
 * </pre>
 *
 * <p>The last term is the speed from which 0.8 of the engine's force can still stop within d: it rules only where the
 * slowing radius is too short for the engine.
 */
final class Seek {
    private static final double BRAKING_SHARE = 0.8;

    private final double slowingRadius; // length

    Seek(double slowingRadius) {
        this.slowingRadius = slowingRadius;
    }

    /** The velocity that the ship in slot {@code i} would like to have. */
    void prefer(Bodies bodies, int i, SteeringVector velocity) {
        double dx = bodies.targetX(i) - bodies.x(i);
        double dy = bodies.targetY(i) - bodies.y(i);
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (distance == 0) {
            velocity.set(0, 0);
            return;
        }
        double topSpeed = bodies.maxSpeed(i);
        double topAcceleration = bodies.maxForce(i) * bodies.inverseMass(i);
        double ramp = topSpeed * Math.min(1, distance / slowingRadius);
        double speed = Math.min(ramp, Math.sqrt(2 * BRAKING_SHARE * topAcceleration * distance));
        velocity.set(dx * speed / distance, dy * speed / distance);
    }
}

package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.steering.SteeringSpec.Arrival;

/**
 * Seek and arrive: towards the target at full speed, and in time slower, so that the ship stops there (Reynolds 1999,
 * "Steering behaviors for autonomous characters").
 *
 * <pre>
 *   linear     v = v_max · min(1, d / slowing radius)
 *   braking    v = min(v_max, √(2 a (d − a/2k²)))   and k d where d &lt; a/k²,   a = 0.98 a_max,   k = 1/2dt
 * </pre>
 *
 * <p>The braking curve stops within d when every tick takes a dt off the speed; near the target, where a tick is too coarse
 * for it, it goes over into a straight line of the same slope. a is what the engine has left against gravity in that direction. The linear arrival follows the curve too
 * where its slowing radius is too short for the engine.
 */
final class Seek implements Preference {
    private static final double BRAKING_SHARE = 0.98; // the rest is for what comes across
    private static final double LINEAR_SHARE = 0.8;

    private final Arrival arrival;
    private final double slowingRadius; // length

    Seek(Arrival arrival, double slowingRadius) {
        this.arrival = arrival;
        this.slowingRadius = slowingRadius;
    }

    @Override
    public void prefer(Bodies bodies, int i, long tick, double dt, SteeringVector velocity) {
        towards(bodies, i, bodies.targetX(i) - bodies.x(i), bodies.targetY(i) - bodies.y(i), dt, velocity);
    }

    /** The same to any place, given relative to the ship. */
    void towards(Bodies bodies, int i, double dx, double dy, double dt, SteeringVector velocity) {
        double distance = Math.sqrt(dx * dx + dy * dy);
        if (distance == 0) {
            velocity.set(0, 0);
            return;
        }
        double ux = dx / distance;
        double uy = dy / distance;
        double most = bodies.maxForce(i) * bodies.inverseMass(i);
        double along = bodies.ax(i) * ux + bodies.ay(i) * uy;
        double across = bodies.ax(i) * uy - bodies.ay(i) * ux;
        double brake = Math.max(0.1 * most, Math.sqrt(Math.max(0, most * most - across * across)) - along);
        double top = topSpeed(bodies, i, ux, uy);
        double speed = Math.min(top, stoppingSpeed(BRAKING_SHARE * brake, distance, dt));
        double sideways = Math.abs(bodies.vx(i) * uy - bodies.vy(i) * ux) / most; // time to lose it
        speed = Math.min(speed, brake * (Math.sqrt(sideways * sideways + 2 * distance / brake) - sideways));
        if (arrival == Arrival.LINEAR) {
            double ramp = bodies.maxSpeed(i) * Math.min(1, distance / slowingRadius);
            double ahead = Math.max(0, distance - slowingRadius);
            speed = Math.min(speed, Math.sqrt(ramp * ramp + 2 * LINEAR_SHARE * brake * ahead));
        }
        velocity.set(ux * speed, uy * speed);
    }

    /** What gravity has given a ship on its way beyond its top speed is welcome. */
    private static double topSpeed(Bodies bodies, int i, double ux, double uy) {
        return Math.max(bodies.maxSpeed(i), bodies.vx(i) * ux + bodies.vy(i) * uy);
    }

    private static double stoppingSpeed(double a, double distance, double dt) {
        double k = 0.5 / dt;
        double straight = a / (k * k);
        if (distance < straight) {
            return k * distance;
        }
        return Math.sqrt(2 * a * (distance - 0.5 * straight));
    }
}

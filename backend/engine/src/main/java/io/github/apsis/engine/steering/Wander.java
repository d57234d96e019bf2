package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import org.jspecify.annotations.Nullable;

/**
 * Smooth exploration: a heading whose turn rate is an Ornstein-Uhlenbeck process (Uhlenbeck and Ornstein 1930, Phys. Rev. 36,
 * 823), so that paths bend without corners, whatever the tick rate.
 *
 * <pre>
 *   ω += −ω dt/τ + σ √dt ξ,   ξ uniform in [−1, 1)        heading turns by ω dt        preferred v = 0.6 v_max · heading
 * </pre>
 *
 * <p>τ and σ scale with the time in which the ship can stop. ξ is a pure function of seed, ship and tick: no order of
 * evaluation can change it. The heading turns by a rational rotation: no trigonometry, the same bits everywhere.
 */
final class Wander implements Preference {
    private static final double CRUISE_SHARE = 0.6;
    private static final double MEMORY = 0.8; // τ in stopping times
    private static final double RESTLESSNESS = 1.4; // σ in stopping times^(−3/2)
    private static final double TURN_BACK = 2.5; // radians per stopping time, near a wall

    private final long seed;
    private final @Nullable Aabb walls;

    Wander(long seed, @Nullable Aabb walls) {
        this.seed = seed;
        this.walls = walls;
    }

    /** Turns the heading by one tick and prefers to follow it. */
    @Override
    public void prefer(Bodies bodies, int i, long tick, double dt, SteeringVector velocity) {
        double stoppingTime = bodies.maxSpeed(i) / (bodies.maxForce(i) * bodies.inverseMass(i));
        double noise = 2 * Rng.unitAt(seed, bodies.idValue(i), tick) - 1;
        double turnRate = bodies.turnRate(i);
        turnRate -= turnRate * Math.min(1, dt / (MEMORY * stoppingTime));
        turnRate += RESTLESSNESS * Math.sqrt(dt) / (stoppingTime * Math.sqrt(stoppingTime)) * noise;

        double half = 0.5
                * dt
                * (turnRate
                        + turnBack(bodies, i, stoppingTime)); // half the angle, as its tangent: exact to third order
        double norm = 1 / (1 + half * half);
        double cos = (1 - half * half) * norm;
        double sin = 2 * half * norm;
        double hx = cos * bodies.headingX(i) - sin * bodies.headingY(i);
        double hy = sin * bodies.headingX(i) + cos * bodies.headingY(i);
        double length = Math.sqrt(hx * hx + hy * hy);
        bodies.setHeading(i, hx / length, hy / length, turnRate);
        double speed = CRUISE_SHARE * bodies.maxSpeed(i);
        velocity.set(speed * hx / length, speed * hy / length);
    }

    /** How fast to turn away from the walls: nothing while the heading points inwards, or far from all of them. */
    private double turnBack(Bodies bodies, int i, double stoppingTime) {
        if (walls == null) {
            return 0;
        }
        double near = bodies.maxSpeed(i) * stoppingTime + bodies.radius(i);
        double inX = inwards(bodies.x(i), walls.minX() + near, walls.maxX() - near);
        double inY = inwards(bodies.y(i), walls.minY() + near, walls.maxY() - near);
        double along = bodies.headingX(i) * inX + bodies.headingY(i) * inY;
        if (along > 0 || (inX == 0 && inY == 0)) {
            return 0;
        }
        double side = bodies.headingX(i) * inY - bodies.headingY(i) * inX;
        return (side >= 0 ? TURN_BACK : -TURN_BACK) / stoppingTime;
    }

    private static double inwards(double position, double low, double high) {
        if (position < low) {
            return 1;
        }
        return position > high ? -1 : 0;
    }
}

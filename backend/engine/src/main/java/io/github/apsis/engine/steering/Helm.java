package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.steering.SteeringSpec.Avoidance;
import org.jspecify.annotations.Nullable;

/**
 * Steers ships one by one: what a ship prefers, then its course, then the thrust towards it.
 *
 * <pre>
 *   thrust = m · limit((course − v) / τ − g, a_max)
 * </pre>
 *
 * <p>τ is a quarter of the stopping time, and a tick where a target is near. The pull g of gravity is taken off the command, so that
 * a ship can stop in a field; but what pulls a ship along at full speed is welcome, and is let be. Thrust alone never lifts a ship above its maximum speed.
 *
 * <p>It reads what a decision began with and writes the ship that it steers alone: several helms may share the ships of a world.
 */
final class Helm {
    private static final double RESPONSE = 0.25; // stopping times
    private static final double FULL_SPEED = 0.98; // of the top speed

    private final SteeringSpec spec;
    private final Seek seek;
    private final Preference wander;
    private final Planner planner;
    private final SteeringVector preferred = new SteeringVector();
    private final SteeringVector command = new SteeringVector();

    Helm(
            SteeringSpec spec,
            Neighbours neighbours,
            Courses courses,
            double gravity,
            Preference wander,
            @Nullable Aabb walls,
            @Nullable Period period) {
        this.spec = spec;
        this.wander = wander;
        seek = new Seek(spec.arrival(), spec.slowingRadius());
        planner = new Planner(seek, neighbours, courses, gravity, walls, period);
    }

    /** How fast a velocity follows its course, time. */
    static double response(Bodies bodies, int i) {
        return RESPONSE * Planner.stoppingTime(bodies, i);
    }

    void steer(Bodies bodies, int i, long tick, double dt) {
        boolean seeks = bodies.hasTarget(i);
        (seeks ? seek : wander).prefer(bodies, i, tick, dt, preferred);
        double nearness = seeks ? nearness(bodies, i) : 0;
        if (spec.avoidance() == Avoidance.PLANNED && Planner.isDue(bodies, i, tick, dt)) {
            planner.plan(bodies, i, preferred, nearness, dt);
        } else if (spec.avoidance() != Avoidance.PLANNED || !bodies.isEvading(i)) {
            bodies.setCourse(i, preferred.x, preferred.y, false);
        }
        if (spec.avoidance() == Avoidance.PLANNED || spec.avoidance() == Avoidance.NONE) {
            boolean direct = nearness == 1 && !bodies.isEvading(i);
            follow(bodies, i, direct ? dt : Math.max(dt, response(bodies, i)), seeks);
        } else {
            SourceRule.thrust(
                    bodies, i, preferred, seeks && spec.avoidance() == Avoidance.SOURCE_SEEK_FIRST, dt, command);
        }
        keepBelowTopSpeed(bodies, i, dt);
        bodies.setThrust(i, command.x * bodies.mass(i), command.y * bodies.mass(i));
    }

    /** 1 within the slowing radius of the target, less in proportion farther away. */
    private double nearness(Bodies bodies, int i) {
        double dx = bodies.targetX(i) - bodies.x(i);
        double dy = bodies.targetY(i) - bodies.y(i);
        double distance = Math.sqrt(dx * dx + dy * dy);
        return distance <= spec.slowingRadius() ? 1 : spec.slowingRadius() / distance;
    }

    private void follow(Bodies bodies, int i, double response, boolean seeks) {
        double wx = bodies.courseX(i);
        double wy = bodies.courseY(i);
        double gx = bodies.ax(i);
        double gy = bodies.ay(i);
        double full = FULL_SPEED * bodies.maxSpeed(i);
        double w2 = wx * wx + wy * wy;
        if (seeks && w2 >= full * full) {
            double along = Math.max(0, (gx * wx + gy * wy) / w2);
            gx -= along * wx;
            gy -= along * wy;
        }
        command.set((wx - bodies.vx(i)) / response - gx, (wy - bodies.vy(i)) / response - gy);
        command.limit(bodies.maxForce(i) * bodies.inverseMass(i));
    }

    /** Cuts the command so that it does not lift the ship above its top speed; gravity may. */
    private void keepBelowTopSpeed(Bodies bodies, int i, double dt) {
        double fx = bodies.vx(i) + bodies.ax(i) * dt;
        double fy = bodies.vy(i) + bodies.ay(i) * dt;
        double limit = Math.max(bodies.maxSpeed(i), Math.sqrt(fx * fx + fy * fy));
        double wx = fx + command.x * dt;
        double wy = fy + command.y * dt;
        double speed = Math.sqrt(wx * wx + wy * wy);
        if (speed > limit) {
            command.set((wx * limit / speed - fx) / dt, (wy * limit / speed - fy) / dt);
        }
    }
}

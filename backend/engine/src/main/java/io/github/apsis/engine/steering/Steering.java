package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.spatial.Quadtree;
import org.jspecify.annotations.Nullable;

/**
 * Decides one thrust per ship and tick, held through the tick.
 *
 * <p>A ship prefers a velocity, by {@link Seek} while it has a target and by {@link Wander} otherwise. {@link Avoid} takes
 * what it needs of the engine's force first; the rest tracks the preferred velocity. The pull of gravity is taken off the
 * command, so that a ship can stop in a field. Thrust alone never lifts a ship above its maximum speed.
 *
 * <p>All ships read the same positions and velocities and write only their own thrust: their order does not matter.
 */
public final class Steering {
    /** How fast the velocity follows the preferred one, in stopping times: fast enough to feel direct, without trembling. */
    private static final double RESPONSE = 0.15;

    private final Quadtree tree = new Quadtree();
    private final Seek seek;
    private final Wander wander;
    private final Avoid avoid;
    private final SteeringVector preferred = new SteeringVector();
    private final SteeringVector push = new SteeringVector();
    private final SteeringVector command = new SteeringVector();

    /**
     * @param slowingRadius of arrivals, length
     * @param gravity G of the world, length³ / (mass · time²); 0 without attraction
     * @param seed of the wanderers
     * @param walls that wanderers turn away from
     * @param period of a world that repeats itself
     */
    public Steering(double slowingRadius, double gravity, long seed, @Nullable Aabb walls, @Nullable Period period) {
        seek = new Seek(slowingRadius);
        wander = new Wander(seed, walls);
        avoid = new Avoid(tree, gravity, period);
    }

    /** Sets the thrust of every ship; accelerations must belong to the present positions. */
    public void decide(Bodies bodies, long tick, double dt) {
        if (bodies.ships().length == 0) {
            return;
        }
        buildTree(bodies);
        for (int ship : bodies.ships()) {
            if (!bodies.isFixed(ship)) {
                decide(bodies, ship, tick, dt);
            }
        }
    }

    private void buildTree(Bodies bodies) {
        tree.begin(bodies.count());
        for (int i = 0; i < bodies.count(); i++) {
            double r = bodies.radius(i);
            tree.set(i, bodies.x(i) - r, bodies.y(i) - r, bodies.x(i) + r, bodies.y(i) + r);
        }
        tree.build();
    }

    private void decide(Bodies bodies, int i, long tick, double dt) {
        if (bodies.hasTarget(i)) {
            seek.prefer(bodies, i, preferred);
        } else {
            wander.prefer(bodies, i, tick, dt, preferred);
        }
        avoid.push(bodies, i, push);

        double most = bodies.maxForce(i) * bodies.inverseMass(i);
        double response = Math.max(dt, RESPONSE * bodies.maxSpeed(i) / most);
        command.set((preferred.x - bodies.vx(i)) / response, (preferred.y - bodies.vy(i)) / response);
        command.limit(most - push.length());
        command.add(push.x - bodies.ax(i), push.y - bodies.ay(i));
        command.limit(most);
        keepBelowTopSpeed(bodies, i, dt);
        bodies.setThrust(i, command.x * bodies.mass(i), command.y * bodies.mass(i));
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

package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Period;
import org.jspecify.annotations.Nullable;

/**
 * Decides one thrust per ship and tick, held through the tick.
 *
 * <p>A ship prefers a velocity, by {@link Seek} while it has a target and by {@link Wander} otherwise; the {@link Planner}
 * makes a course of it that keeps clear of others, and the {@link Helm} a thrust. A target replaces wandering, never avoidance.
 *
 * <p>All ships read what was true at the start and write their own columns alone: neither their order nor the number of
 * threads can change a bit. What a ship remembers is in {@link Bodies}; from one tick to the next nothing is kept here.
 */
public final class Steering {
    private final Neighbours neighbours = new Neighbours();
    private final Courses courses = new Courses();
    private final Helm helm;

    /**
     * Steering whose wanderers go where chance leads them.
     *
     * @param gravity G of the world, length³ / (mass · time²); 0 without attraction
     * @param seed of the wanderers
     * @param walls around the ships
     * @param period of a world that repeats itself
     */
    public Steering(SteeringSpec spec, double gravity, long seed, @Nullable Aabb walls, @Nullable Period period) {
        this(spec, gravity, new Wander(seed, walls), walls, period);
    }

    /** Steering whose ships without a target go where somebody else wants them to. */
    public Steering(
            SteeringSpec spec, double gravity, Preference wander, @Nullable Aabb walls, @Nullable Period period) {
        helm = new Helm(spec, neighbours, courses, gravity, wander, walls, period);
    }

    /** Sets the thrust of every ship; accelerations must belong to the present positions. */
    public void decide(Bodies bodies, long tick, double dt) {
        int[] ships = bodies.ships();
        if (ships.length == 0) {
            return;
        }
        double range = 0;
        for (int i : ships) {
            range = Math.max(range, Planner.range(bodies, i));
        }
        neighbours.sort(bodies, range);
        courses.copy(bodies);
        for (int i : ships) {
            if (!bodies.isFixed(i)) {
                helm.steer(bodies, i, tick, dt);
            }
        }
    }
}

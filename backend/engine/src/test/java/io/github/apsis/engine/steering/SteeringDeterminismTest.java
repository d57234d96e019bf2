package io.github.apsis.engine.steering;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.spatial.Workspace;
import java.lang.management.ManagementFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What a decision may depend on: the bodies as they are, the seed and the tick. */
class SteeringDeterminismTest {
    private static final double DT = 1.0 / 150;
    private static final Aabb WALLS = Aabb.centred(400, 400);

    @Test
    void a_world_that_is_saved_and_loaded_goes_on_as_if_nothing_had_happened() {
        Bodies bodies = crowd();
        Bodies loaded = crowd();
        Steering steering = steering();

        for (int tick = 0; tick < 600; tick++) {
            step(steering, bodies, tick);
            step(steering(), loaded, tick); // a new one each time: whatever it knew is gone
        }

        assertThat(loaded.hash()).isEqualTo(bodies.hash());
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 8})
    void a_crowd_has_the_same_history_by_any_number_of_threads_after_loading_too(int threads) {
        Bodies alone = crowd(300);
        Bodies together = crowd(300);
        Steering byOne = steering();

        try (Team team = new Team(threads)) {
            Steering byAll = steering(team);
            for (int tick = 0; tick < 200; tick++) {
                step(byOne, alone, tick);
                step(byAll, together, tick);
            }
            Bodies loaded = copyOf(together);
            Steering afterwards = steering(team);
            for (int tick = 200; tick < 400; tick++) {
                step(byOne, alone, tick);
                step(afterwards, loaded, tick);
            }

            assertThat(loaded.hash()).isEqualTo(alone.hash());
        }
    }

    @Test
    void the_order_of_ships_and_so_their_share_among_threads_changes_nothing() {
        Bodies forwards = crowd();
        Bodies backwards = crowd();
        var steering = steering();
        var neighbours = new Neighbours(Team.ofOne(), new Workspace());
        var courses = new Courses();
        Helm[] helms = {helm(neighbours, courses), helm(neighbours, courses), helm(neighbours, courses)};

        for (int tick = 0; tick < 300; tick++) {
            step(steering, forwards, tick);
            neighbours.sort(backwards, 300);
            courses.copy(backwards);
            int[] ships = backwards.ships();
            for (int k = ships.length - 1; k >= 0; k--) {
                helms[k % 3].steer(backwards, ships[k], tick, DT);
            }
            move(backwards);
        }

        assertThat(backwards.hash()).isEqualTo(forwards.hash());
    }

    @Test
    void deciding_allocates_nothing_once_warm() {
        Bodies bodies = crowd();
        Steering steering = steering();
        var threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        for (int tick = 0; tick < 300; tick++) {
            step(steering, bodies, tick);
        }

        long before = threads.getCurrentThreadAllocatedBytes();
        for (int tick = 300; tick < 600; tick++) {
            steering.decide(bodies, tick, DT);
        }
        long after = threads.getCurrentThreadAllocatedBytes();

        // The measurement itself and the compiler's own dealings take some; a byte per ship and tick would be 18 000.
        assertThat(after - before).isLessThan(5000);
    }

    private static Steering steering() {
        return steering(Team.ofOne());
    }

    private static Steering steering(Team team) {
        return new Steering(SteeringSpec.DEFAULT, 0, 7, WALLS, null, team, new Workspace());
    }

    private static Helm helm(Neighbours neighbours, Courses courses) {
        return new Helm(SteeringSpec.DEFAULT, neighbours, courses, 0, new Wander(7, WALLS), WALLS, null);
    }

    private static void step(Steering steering, Bodies bodies, int tick) {
        steering.decide(bodies, tick, DT);
        move(bodies);
    }

    private static void move(Bodies bodies) {
        bodies.kick(DT);
        bodies.drift(DT);
    }

    private static Bodies crowd() {
        return crowd(80);
    }

    /** What a file that holds the columns of all bodies gives back. */
    private static Bodies copyOf(Bodies saved) {
        var loaded = new Bodies();
        for (int i = 0; i < saved.count(); i++) {
            double x = saved.x(i);
            double y = saved.y(i);
            BodyDef def = saved.isShip(i)
                    ? BodyDef.ship(x, y, saved.mass(i), saved.radius(i), new ShipLimits(120, 200))
                    : BodyDef.asteroid(x, y, saved.mass(i), saved.radius(i));
            loaded.add(def);
            loaded.place(i, x, saved.xLow(i), y, saved.yLow(i));
            loaded.setVelocity(i, saved.vx(i), saved.vxLow(i), saved.vy(i), saved.vyLow(i));
            if (saved.isShip(i)) {
                loaded.setHeading(i, saved.headingX(i), saved.headingY(i), saved.turnRate(i));
                loaded.setThrust(i, saved.thrustX(i), saved.thrustY(i));
                loaded.setCourse(i, saved.courseX(i), saved.courseY(i), saved.isEvading(i));
                loaded.setThreat(i, saved.threat(i), saved.contactIn(i));
                if (saved.hasTarget(i)) {
                    loaded.setTarget(i, saved.targetX(i), saved.targetY(i));
                }
            }
        }
        assertThat(loaded.hash()).isEqualTo(saved.hash());
        return loaded;
    }

    private static Bodies crowd(int count) {
        var rng = new Rng(3);
        var bodies = new Bodies();
        for (int i = 0; i < count; i++) {
            double x = rng.between(-380, 380);
            double y = rng.between(-380, 380);
            BodyDef body = i % 4 == 0
                    ? BodyDef.asteroid(x, y, 1, rng.between(4, 15))
                    : BodyDef.ship(x, y, 1, 8, new ShipLimits(120, 200));
            int slot = bodies.add(body.moving(rng.between(-30, 30), rng.between(-30, 30)));
            if (i % 4 == 1) {
                bodies.setTarget(slot, rng.between(-380, 380), rng.between(-380, 380));
            }
        }
        return bodies;
    }
}

package io.github.apsis.engine.collision;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.ReferenceCase;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Rng;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Contacts that happen at the same moment, in any direction of the plane: turned, the same circles touch an ulp earlier or later, and
 * nobody may see which.
 */
class SimultaneousContactsTest {
    private static final int DIRECTIONS = 24;

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 0.8, 1})
    void a_cue_between_two_balls_leaves_them_mirror_images(double e) {
        for (int k = 0; k < DIRECTIONS; k++) {
            Turn turn = Turn.number(k);
            World world = world(e, turn, ReferenceCase.simultaneous("cue-on-two"));

            run(world, 900);

            WorldSnapshot now = world.snapshot();
            assertThat(turn.alongY(now, 0)).as("direction %d", k).isCloseTo(0, within(1e-9));
            assertThat(turn.alongX(now, 1)).as("direction %d", k).isCloseTo(turn.alongX(now, 2), within(1e-9));
            assertThat(turn.alongY(now, 1)).as("direction %d", k).isCloseTo(-turn.alongY(now, 2), within(1e-9));
            assertThat(turn.alongX(now, 1)).as("direction %d", k).isGreaterThan(0.2); // both were hit
            assertMomentumAndEnergy(now, turn, 1, 0.5);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 0.8, 1})
    void a_ball_hit_from_both_sides_at_once_stays(double e) {
        for (int k = 0; k < DIRECTIONS; k++) {
            Turn turn = Turn.number(k);
            World world = world(e, turn, ReferenceCase.simultaneous("sandwich"));

            run(world, 900);

            WorldSnapshot now = world.snapshot();
            assertThat(turn.alongX(now, 1)).as("direction %d", k).isCloseTo(0, within(1e-9));
            assertThat(turn.alongX(now, 0)).as("direction %d", k).isCloseTo(-turn.alongX(now, 2), within(1e-9));
            assertThat(turn.alongX(now, 2)).as("direction %d", k).isBetween(-1e-12, 1 + 1e-12);
            if (e == 1) {
                assertThat(turn.alongX(now, 2)).as("direction %d", k).isCloseTo(1, within(1e-9));
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"touching-row, 1", "two-on-row, 2"})
    void as_many_touching_balls_leave_as_arrive(String id, int arriving) {
        for (int k = 0; k < DIRECTIONS; k++) {
            Turn turn = Turn.number(k);
            World world = world(1, turn, ReferenceCase.simultaneous(id));

            run(world, 900);

            assertLastLeave(world.snapshot(), turn, arriving, k);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {5, 20})
    void a_cradle_of_touching_balls_hands_on_the_whole_velocity(int count) {
        for (int k = 0; k < DIRECTIONS; k++) {
            Turn turn = Turn.number(k);
            World world = new World(WorldSpec.builder().contacts(1).build());
            world.add(turn.of(BodyDef.asteroid(-1, 0, 1, 0.1).moving(1, 0)));
            for (int i = 0; i < count - 1; i++) {
                world.add(turn.of(BodyDef.asteroid(0.2 * i, 0, 1, 0.1)));
            }

            run(world, 300);

            assertLastLeave(world.snapshot(), turn, 1, k);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {5, 20})
    void gaps_and_overlaps_of_an_ulp_make_no_difference_to_a_cradle(int count) {
        for (long seed = 0; seed < DIRECTIONS; seed++) {
            var rng = new Rng(seed);
            World world = new World(WorldSpec.builder().contacts(1).build());
            world.add(BodyDef.asteroid(-1, 0, 1, 0.1).moving(1, 0));
            for (int i = 0; i < count - 1; i++) {
                double x = 0.2 * i;
                world.add(BodyDef.asteroid(x + (rng.nextInt(5) - 2) * Math.ulp(x), 0, 1, 0.1));
            }

            run(world, 300);

            assertLastLeave(world.snapshot(), Turn.number(0), 1, seed);
        }
    }

    private static void assertLastLeave(WorldSnapshot now, Turn turn, int leaving, long k) {
        for (int i = 0; i < now.count(); i++) {
            double speed = i < now.count() - leaving ? 0 : 1;
            assertThat(turn.alongX(now, i))
                    .as("ball %d, direction or seed %d", i, k)
                    .isCloseTo(speed, within(1e-9));
            assertThat(turn.alongY(now, i))
                    .as("ball %d, direction or seed %d", i, k)
                    .isCloseTo(0, within(1e-9));
        }
    }

    private static void assertMomentumAndEnergy(WorldSnapshot now, Turn turn, double momentum, double energy) {
        double p = 0;
        double k = 0;
        for (int i = 0; i < now.count(); i++) {
            p += now.mass(i) * turn.alongX(now, i);
            k += 0.5 * now.mass(i) * (now.vx(i) * now.vx(i) + now.vy(i) * now.vy(i));
        }
        assertThat(p).isCloseTo(momentum, within(1e-14));
        assertThat(k).isLessThan(energy * (1 + 1e-12));
    }

    private static World world(double e, Turn turn, List<BodyDef> bodies) {
        World world = new World(WorldSpec.builder().contacts(e).build());
        bodies.forEach(body -> world.add(turn.of(body)));
        return world;
    }

    /** The plane turned about the origin: the first by nothing, then by any angles. */
    private record Turn(double cos, double sin) {
        static Turn number(int k) {
            double angle = k == 0 ? 0 : 0.1 + 0.7 * k;
            return new Turn(StrictMath.cos(angle), StrictMath.sin(angle));
        }

        BodyDef of(BodyDef body) {
            return body.at(cos * body.x() - sin * body.y(), sin * body.x() + cos * body.y())
                    .moving(cos * body.vx() - sin * body.vy(), sin * body.vx() + cos * body.vy());
        }

        double alongX(WorldSnapshot now, int i) {
            return cos * now.vx(i) + sin * now.vy(i);
        }

        double alongY(WorldSnapshot now, int i) {
            return cos * now.vy(i) - sin * now.vx(i);
        }
    }
}

package io.github.apsis.engine.stepping;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.ReferenceCase;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.diagnostics.Drift;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;

/** Exact contacts under gravity. */
class EventStepperTest {
    private static WorldSpec.Builder exact(double restitution) {
        return WorldSpec.builder().gravity(1).adaptive(1e-16).exactContacts(restitution);
    }

    @Test
    void a_ball_bounces_twenty_times_on_a_planet_when_and_as_high_as_it_should() {
        ReferenceCase drop = ReferenceCase.of("planet-drop");
        World world = drop.world(exact(0.8).build());
        List<double[]> bounces = new ArrayList<>();
        world.onBounce((time, a, b, c, impulse) -> bounces.add(new double[] {time, c}));

        run(world, 2700); // 18 s

        int k = 0;
        for (JsonNode truth : drop.node("events")) {
            // Times are wrong by 1e-14; a speed of 0.26 at the end by what that is of the gap, 1e-14 of 101.
            assertThat(bounces.get(k)[0] / truth.get("t").asDouble())
                    .as("time %d", k)
                    .isCloseTo(1, within(1e-13));
            assertThat(bounces.get(k)[1] / -truth.get("vn").asDouble())
                    .as("speed %d", k)
                    .isCloseTo(1, within(1e-11));
            k++;
        }
    }

    @Test
    void an_elastic_ball_bounces_ten_thousand_times_on_a_planet_without_loss() {
        World world = new World(exact(1).dt(0.1).build());
        world.add(BodyDef.planet(0, 0, 1e5, 100));
        world.add(BodyDef.asteroid(101.05, 0, 1, 1).moving(0, 3)); // flights of 0.2 time units, slowly round the planet
        int[] bounces = {0};
        world.onBounce((time, a, b, c, impulse) -> bounces[0]++);
        Conserved before = world.conserved();

        run(world, 21_000);

        assertThat(bounces[0]).isGreaterThan(10_000);
        assertDrift(before, world, 1e-13);
    }

    @Test
    void a_hundred_bodies_fall_together_and_apart_without_drift() {
        World world = new World(exact(1).dt(1.0 / 30).build());
        long seed = 5;
        var rng = new Rng(seed);
        for (int i = 0; i < 100; i++) {
            world.add(BodyDef.asteroid(3 * (i % 10), 3 * (i / 10), rng.between(0.5, 2), rng.between(0.4, 1))
                    .moving(rng.between(-1, 1), rng.between(-1, 1)));
        }
        int[] bounces = {0};
        world.onBounce((time, a, b, c, impulse) -> bounces[0]++);
        Conserved before = world.conserved();

        run(world, 120);

        assertThat(bounces[0]).as("seed %d", seed).isGreaterThan(200);
        assertDrift(before, world, 1e-13);
        assertThat(deepest(world.snapshot())).isLessThan(1e-12);
    }

    @Test
    void a_world_that_is_turned_round_goes_back_through_its_bounces() {
        World there = new World(exact(1).build());
        there.add(BodyDef.planet(0, 0, 100, 2));
        there.add(BodyDef.asteroid(6, 0, 1, 0.5).moving(0, 2));
        there.add(BodyDef.asteroid(-5, 1, 2, 0.7).moving(1, 2));
        WorldSnapshot start = there.snapshot();
        int[] bounces = {0};
        there.onBounce((time, a, b, c, impulse) -> bounces[0]++);
        run(there, 1200);
        WorldSnapshot end = there.snapshot();

        World back = new World(exact(1).build());
        for (int i = 0; i < 3; i++) {
            back.add(BodyDef.planet(end.x(i), end.y(i), end.mass(i), end.radius(i))
                    .moving(-end.vx(i), -end.vy(i)));
        }
        run(back, 1200);

        assertThat(bounces[0]).isGreaterThan(5);
        for (int i = 0; i < 3; i++) { // a bounce off something round enlarges an error some tenfold, there and back
            assertThat(back.snapshot().x(i)).isCloseTo(start.x(i), within(1e-9));
            assertThat(back.snapshot().y(i)).isCloseTo(start.y(i), within(1e-9));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 0.8, 1})
    void a_cue_that_hits_two_at_once_leaves_them_mirror_images(double e) {
        World world =
                new World(WorldSpec.builder().adaptive(1e-16).exactContacts(e).build());
        world.add(BodyDef.asteroid(-4, 0, 1, 1).moving(1, 0));
        world.add(BodyDef.asteroid(0, 1, 1, 1));
        world.add(BodyDef.asteroid(0, -1, 1, 1));

        run(world, 600);

        WorldSnapshot now = world.snapshot();
        // Two impulses j at ±30°: 2 j cos 30° stops the cue, and each contact leaves with e times its closing speed.
        assertThat(now.vx(0)).isCloseTo(1 - 0.6 * (1 + e), within(1e-14));
        assertThat(Math.hypot(now.vx(1), now.vy(1))).isCloseTo(0.2 * Math.sqrt(3) * (1 + e), within(1e-14));
        assertThat(now.vy(0)).isCloseTo(0, within(1e-15));
        assertThat(now.vx(2)).isCloseTo(now.vx(1), within(1e-15));
        assertThat(now.vy(2)).isCloseTo(-now.vy(1), within(1e-15));
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2})
    void as_many_balls_leave_a_touching_row_as_have_struck_it(int striking) {
        World world =
                new World(WorldSpec.builder().adaptive(1e-16).exactContacts(1).build());
        for (int i = 0; i < 6; i++) {
            boolean strikes = i < striking;
            world.add(BodyDef.asteroid(strikes ? i - 3 : i, 0, 1, 0.5).moving(strikes ? 1 : 0, 0));
        }

        run(world, 600);

        for (int i = 0; i < 6; i++) {
            assertThat(world.snapshot().vx(i)).as("ball %d", i).isCloseTo(i < 6 - striking ? 0 : 1, within(1e-14));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 0.8, 1})
    void a_ball_at_rest_on_a_planet_stays_there(double e) {
        World world = new World(exact(e).build());
        world.add(BodyDef.planet(0, 0, 1e5, 100));
        world.add(BodyDef.asteroid(0, 101, 1, 1));
        Conserved before = world.conserved();

        run(world, 1500);

        assertThat(world.snapshot().y(1) - world.snapshot().y(0)).isCloseTo(101, within(1e-9));
        assertThat(world.snapshot().vy(1)).isCloseTo(0, within(1e-12));
        assertThat(energyDrift(before, world)).isLessThan(1e-14);
    }

    @Test
    void a_ball_comes_to_rest_after_its_last_bounce_and_stays() {
        ReferenceCase drop = ReferenceCase.of("planet-drop");
        World world = drop.world(exact(0.8).build());
        int[] bounces = {0};
        world.onBounce((time, a, b, c, impulse) -> bounces[0]++);
        Conserved before = world.conserved();

        run(world, 3000);

        // 18.09 · 0.8ⁿ is above a thousandth of half what gravity gives in a tick, 3.3e-5, until n = 59.
        assertThat(bounces[0]).isEqualTo(60);
        assertThat(world.snapshot().x(1) - world.snapshot().x(0)).isCloseTo(101, within(1e-8));
        assertThat(world.snapshot().vx(1)).isCloseTo(0, within(1e-12));
        assertThat(energyDrift(before, world)).isLessThan(1e-14);
    }

    @Test
    void what_falls_together_without_springing_comes_to_rest_in_a_pile() {
        World world = new World(exact(0.5).build());
        long seed = 5;
        var rng = new Rng(seed);
        for (int i = 0; i < 16; i++) {
            world.add(BodyDef.asteroid(2.5 * (i % 4), 2.5 * (i / 4), rng.between(0.5, 2), rng.between(0.4, 1)));
        }
        Conserved before = world.conserved();
        int[] bounces = {0};
        world.onBounce((time, a, b, c, impulse) -> bounces[0]++);

        run(world, 1500);

        double deepest = 0;
        bounces[0] = 0;
        for (int tick = 0; tick < 150; tick++) {
            world.step();
            deepest = Math.max(deepest, deepest(world.snapshot()));
        }
        assertThat(deepest).as("overlap in radii, seed %d", seed).isLessThan(1e-5);
        assertThat(bounces[0]).as("bounces in a second").isLessThan(1000);
        assertThat(world.lostTime()).isZero();
        // Parting what has sunk by a jerk books its work to first order.
        assertThat(energyDrift(before, world)).isLessThan(1e-6);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.5, 1})
    void what_is_born_in_one_place_is_parted_without_speed(double e) {
        World world = new World(exact(e).build());
        world.add(BodyDef.planet(0, 0, 10, 1));
        world.add(BodyDef.asteroid(0, 0, 1, 1));

        run(world, 600);

        WorldSnapshot now = world.snapshot();
        assertThat(Math.hypot(now.x(1) - now.x(0), now.y(1) - now.y(0))).isCloseTo(2, within(1e-6));
        assertThat(Math.hypot(now.vx(1), now.vy(1))).isLessThan(1e-9);
    }

    @Test
    void a_bullet_between_two_walls_meets_each_of_them_in_turn() {
        World world = new World(WorldSpec.builder()
                .adaptive(1e-16)
                .exactContacts(1)
                .walls(Aabb.centred(5, 5), 1)
                .build());
        world.add(BodyDef.asteroid(0, 0, 1, 1).moving(3e4, 1.7e4)); // 39 bounces a tick
        int[] bounces = {0};
        world.onBounce((time, a, b, c, impulse) -> bounces[0]++);

        run(world, 150);

        assertThat(bounces[0]).isEqualTo(3750 + 2125); // in a second: a wall for every 8 of the way
        assertThat(world.snapshot().x(0)).isCloseTo(0, within(1e-7));
    }

    private static void assertDrift(Conserved before, World world, double most) {
        Drift drift = Drift.between(before, world.conserved());
        assertThat(Math.abs(drift.energy().orElseThrow())).as("energy").isLessThan(most);
        assertThat(drift.momentum()).as("momentum").isLessThan(most);
        assertThat(Math.abs(drift.angularMomentum().orElseThrow()))
                .as("angular momentum")
                .isLessThan(most);
    }

    private static double energyDrift(Conserved before, World world) {
        return Math.abs(Drift.between(before, world.conserved()).energy().orElseThrow());
    }

    private static double deepest(WorldSnapshot now) {
        double deepest = 0;
        for (int i = 0; i < now.count(); i++) {
            for (int j = i + 1; j < now.count(); j++) {
                double distance = Math.hypot(now.x(j) - now.x(i), now.y(j) - now.y(i));
                deepest = Math.max(deepest, 1 - distance / (now.radius(i) + now.radius(j)));
            }
        }
        return deepest;
    }
}

package io.github.apsis.engine;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.WorldSpec.Integration;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.engine.body.Mobility;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import java.math.BigDecimal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The hard inputs of {@code robust.json}; physics.md, "Hard inputs", tells the outcomes. */
class RobustInputsTest {
    private static final int TICKS = 1500; // default_ticks of the reference

    @Test
    void two_bodies_in_one_place_do_not_pull_each_other() {
        World world = robust("coincident-gravity", gravity());

        WorldSnapshot start = world.snapshot();
        run(world, TICKS);

        assertThat(start.ax(0)).isZero();
        assertThat(start.ay(1)).isZero();
        assertFinite(world);
        assertThat(world.snapshot().x(0)).isEqualTo(2);
    }

    @Test
    void coincident_discs_part_along_the_x_axis_and_the_lighter_gives_way_more() {
        World world = robust("coincident-discs", contacts(0.5));

        run(world, TICKS);

        WorldSnapshot now = world.snapshot();
        assertThat(now.x(0)).isCloseTo(-4.0 / 3, within(4e-7)); // two radii apart but for the slop, masses 1 and 2
        assertThat(now.x(1)).isCloseTo(2.0 / 3, within(2e-7));
        assertThat(now.y(0)).isZero();
        assertThat((now.x(0) + 2 * now.x(1)) / 3).isCloseTo(0, within(Math.ulp(1.0)));
        assertThat(world.conserved().kinetic()).isZero();
    }

    @Test
    void a_thousand_bodies_in_one_place_are_bounded_work_and_do_not_pull() {
        World world = robust("many-coincident", gravity().contacts(0.5));

        run(world, 10); // every pair is a pair of points in contact range: half a million, and still no contact

        WorldSnapshot now = world.snapshot();
        for (int i = 0; i < now.count(); i++) {
            assertThat(now.ax(i)).isZero();
            assertThat(now.x(i)).isEqualTo(0.1);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"nearly-coincident", "tiny-distance", "huge-distance", "denormal"})
    void extreme_distances_and_masses_stay_numbers(String id) {
        World world = robust(id, gravity());

        run(world, 20);

        assertFinite(world);
    }

    @Test
    void nearer_than_1e_103_is_coincident_and_farther_than_1e102_too_weak_to_feel() {
        assertThat(robust("tiny-distance", gravity()).snapshot().ax(0)).isZero(); // truly 1e20
        assertThat(robust("huge-distance", gravity()).snapshot().ax(0)).isZero(); // truly 1e-290
    }

    @Test
    void a_grain_of_1e_12_orbits_a_planet_of_1e30() {
        ReferenceCase grain = ReferenceCase.robust("mass-1e-12-1e30");
        double period = 2 * Math.PI * 1e10 / 81694.55306;
        World world = grain.world(
                WorldSpec.builder().gravity(grain.number("G")).dt(period / 942).build());
        World unit =
                new World(WorldSpec.builder().gravity(1).dt(2 * Math.PI / 942).build());
        unit.add(BodyDef.planet(0, 0, 1, 0));
        unit.add(BodyDef.planet(1, 0, 0, 0).moving(0, 1));

        run(world, 942);
        run(unit, 942);

        WorldSnapshot now = world.snapshot();
        double error = Math.hypot(now.x(1) - 1e10, now.y(1)) / 1e10;
        double sameWithUnitMasses =
                Math.hypot(unit.snapshot().x(1) - 1, unit.snapshot().y(1));
        assertThat(error).isCloseTo(sameWithUnitMasses, within(1e-9)); // the mass ratio costs nothing
        assertThat(error).isLessThan(1e-4); // Verlet: 2π/3 (n dt)²
        assertThat(now.vx(0))
                .isNotZero(); // the recoil, 1e-42 of the grain's speed, is not lost while the planet is at rest
    }

    @Test
    void a_body_without_mass_feels_and_is_not_felt() {
        World world = robust("mass-zero", gravity());

        run(world, 942); // 2π, one round

        WorldSnapshot now = world.snapshot();
        assertThat(Math.hypot(now.x(1), now.y(1))).isCloseTo(1, within(2e-5)); // Verlet's swing, (n dt)²/2
        assertThat(now.x(0)).isZero();
        assertThat(now.vx(0)).isZero();
    }

    @Test
    void in_a_contact_no_mass_is_the_limit_of_a_small_one() {
        World world = new World(contacts(0.5).build());
        world.add(BodyDef.asteroid(-2, 0, 0, 0.5).moving(1, 0));
        world.add(BodyDef.asteroid(0, 0, 3, 0.5));

        run(world, 300);

        assertThat(world.snapshot().vx(0)).isCloseTo(-0.5, within(1e-15)); // −e v
        assertThat(world.snapshot().vx(1)).isCloseTo(0, within(1e-149)); // not 0, but next to it
    }

    @Test
    void two_bodies_without_mass_share_an_impulse_evenly() {
        World world = new World(contacts(1).build());
        world.add(BodyDef.asteroid(-2, 0, 0, 0.5).moving(1, 0));
        world.add(BodyDef.asteroid(0, 0, 0, 0.5));

        run(world, 300);

        assertThat(world.snapshot().vx(0)).isCloseTo(0, within(1e-15));
        assertThat(world.snapshot().vx(1)).isCloseTo(1, within(1e-15));
        assertThat(world.conserved().kinetic()).isZero();
    }

    @Test
    void a_ship_needs_mass_for_its_engine() {
        assertThatThrownBy(() -> BodyDef.ship(0, 0, 0, 1, new ShipLimits(1, 1)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("mass of a ship must be positive and finite, was 0.0");
    }

    @ParameterizedTest
    @CsvSource({
        "mass, -1",
        "mass, NaN",
        "mass, Infinity",
        "radius, -1",
        "radius, NaN",
        "radius, Infinity",
        "x, NaN",
        "y, -Infinity",
        "vx, NaN",
        "vy, Infinity"
    })
    void what_is_no_number_is_refused_by_name(String field, double value) {
        assertThatThrownBy(() -> new BodyDef(
                        BodyKind.PLANET,
                        field.equals("x") ? value : 0,
                        field.equals("y") ? value : 0,
                        field.equals("vx") ? value : 0,
                        field.equals("vy") ? value : 0,
                        field.equals("mass") ? value : 1,
                        field.equals("radius") ? value : 1,
                        Mobility.FREE,
                        null))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith(field + " must be ")
                .hasMessageEndingWith("was " + value);
    }

    @Test
    void far_from_the_origin_an_orbit_stays_closed_and_the_world_says_how_fine_it_is() {
        World near = new World(gravity().build());
        near.add(BodyDef.planet(-0.5, 0, 0.5, 0).moving(0, -0.5));
        near.add(BodyDef.planet(0.5, 0, 0.5, 0).moving(0, 0.5));
        World far = robust("offset-1e9", gravity());
        assertThat(far.resolution()).isCloseTo(Math.ulp(1e9) / (0.5 / 150), within(1e-8)); // 3.6e-5

        int tenRounds = (int) Math.round(10 * 2 * Math.PI * 150);
        run(near, tenRounds);
        run(far, tenRounds);

        assertThat(separation(far)).isCloseTo(1, within(1e-6));
        assertThat(separation(far)).isCloseTo(separation(near), within(1e-6));
        double e0 = -0.125;
        assertThat(far.conserved().energy().orElseThrow() / e0).isCloseTo(1, within(1e-6));
    }

    @Test
    void where_doubles_are_an_eighth_apart_rounding_makes_no_energy_and_the_world_gives_warning() {
        World world = robust("offset-1e15", gravity());

        double fastest = 0;
        for (int tick = 0; tick < 10 * TICKS; tick++) {
            world.step();
            WorldSnapshot now = world.snapshot();
            fastest = Math.max(fastest, Math.max(Math.hypot(now.vx(0), now.vy(0)), Math.hypot(now.vx(1), now.vy(1))));
        }

        assertThat(world.resolution()).isGreaterThan(1);
        assertThat(fastest).isLessThan(2 * 0.5); // twice the first speed
    }

    @Test
    void a_tick_of_no_length_changes_no_bit() {
        World world = new World(gravity()
                .contacts(0.5)
                .walls(Aabb.centred(50, 50), 0.5)
                .dt(ReferenceCase.robust("dt-zero").number("dt"))
                .build());
        world.add(BodyDef.planet(0, 0, 10, 1));
        world.add(BodyDef.asteroid(1.5, 0, 1, 1).moving(-1, 0)); // in each other, and closing
        world.add(BodyDef.ship(10, 0, 1, 1, new ShipLimits(10, 10)));
        world.snapshot(); // makes the accelerations current
        long before = world.stateHash();

        run(world, 10);

        assertThat(world.stateHash()).isEqualTo(before + 10); // the tick alone
        assertThat(world.time()).isZero();
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1.0 / 150, Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void time_runs_forwards_in_finite_steps(double dt) {
        assertThatThrownBy(() -> WorldSpec.builder().dt(dt))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("dt must be 0 or more and finite, was " + dt);
    }

    @ParameterizedTest
    @CsvSource({
        "dt-tiny, VELOCITY_VERLET",
        "dt-tiny, SEMI_IMPLICIT_EULER",
        "dt-huge, VELOCITY_VERLET",
        "dt-huge, SEMI_IMPLICIT_EULER"
    })
    void ticks_of_1e_18_and_of_1e6_end_and_stay_numbers_and_inside_the_walls(String id, Integration integration) {
        double dt = ReferenceCase.robust(id).number("dt");
        World orbit = ReferenceCase.of("kepler-e05-equal")
                .world(WorldSpec.builder()
                        .gravity(1)
                        .integration(integration)
                        .dt(dt)
                        .build());
        World pile = pileOfTen(dt, integration);

        run(orbit, TICKS);
        assertFinite(orbit);
        for (int tick = 0; tick < TICKS; tick++) {
            pile.step();
            WorldSnapshot now = pile.snapshot();
            for (int i = 0; i < now.count(); i++) {
                assertThat(Math.abs(now.x(i))).isLessThanOrEqualTo(5); // centres; rims may be pressed in
                assertThat(now.y(i)).isBetween(0.0, 20.0);
            }
        }
        assertFinite(pile);
    }

    @Test
    void points_never_touch() {
        World world = robust("radius-zero-contact", contacts(0.5));

        run(world, 300);

        assertThat(world.snapshot().vx(0)).isEqualTo(1);
        assertThat(world.snapshot().vx(1)).isEqualTo(-1);
    }

    @Test
    void discs_that_just_touch_and_rest_are_left_alone() {
        World world = robust("touching-at-rest", contacts(0.5));
        long before = world.stateHash();

        run(world, TICKS);

        assertThat(world.stateHash()).isEqualTo(before + TICKS);
    }

    @Test
    void discs_that_just_touch_and_part_are_left_alone() {
        World world = new World(contacts(0.5).build());
        world.add(BodyDef.asteroid(0, 0, 1, 0.5).moving(-0.25, 0));
        world.add(BodyDef.asteroid(1, 0, 1, 0.5).moving(0.25, 0));

        run(world, 300);

        assertThat(world.snapshot().vx(0)).isEqualTo(-0.25);
        assertThat(world.snapshot().vx(1)).isEqualTo(0.25);
    }

    @Test
    void fifty_discs_born_in_one_heap_spread_by_ten_radii_a_second_at_most_and_never_move() {
        World world = new World(contacts(0.5).build());
        long seed = 3;
        var rng = new Rng(seed);
        while (world.count() < 50) {
            double x = rng.between(-2, 2);
            double y = rng.between(-2, 2);
            if (x * x + y * y <= 4) {
                world.add(BodyDef.asteroid(x, y, 1, 1));
            }
        }

        WorldSnapshot before = world.snapshot();
        for (int tick = 0; tick < TICKS; tick++) {
            world.step();
            WorldSnapshot now = world.snapshot();
            for (int i = 0; i < now.count(); i++) {
                double way = Math.hypot(now.x(i) - before.x(i), now.y(i) - before.y(i));
                assertThat(way * 150).as("seed %d", seed).isLessThanOrEqualTo(10 * (1 + 1e-9));
            }
            before = now;
        }

        assertThat(world.conserved().kinetic()).isZero();
        assertThat(world.conserved().momentumScale()).isZero();
        assertThat(world.ledger().energy()).isZero();
        for (int i = 0; i < 50; i++) {
            for (int j = i + 1; j < 50; j++) {
                double distance = Math.hypot(before.x(i) - before.x(j), before.y(i) - before.y(j));
                assertThat(distance).as("seed %d", seed).isGreaterThan(2 - 1e-6); // the slop
            }
        }
    }

    @Test
    void a_body_that_a_million_times_its_mass_lies_on_is_not_pressed_into_the_floor() {
        World world = robust(
                "mass-ratio-stack", contacts(0.5).law(new UniformField(0, -10)).walls(new Aabb(-50, 0, 50, 50), 0.5));
        double start = world.conserved().energy().orElseThrow();
        double allowed = ReferenceCase.robust("mass-ratio-stack")
                .node("check")
                .get("overlap_max")
                .asDouble();

        for (int tick = 0; tick < TICKS; tick++) {
            world.step();
            WorldSnapshot now = world.snapshot();
            assertThat(0.5 - now.y(0)).isLessThan(allowed);
            assertThat(1 - (now.y(1) - now.y(0))).isLessThan(allowed);
            assertThat(world.conserved().energy().orElseThrow()).isLessThanOrEqualTo(start * (1 + 1e-12));
        }
        assertThat(world.snapshot().vy(1)).isCloseTo(0, within(1e-9));
    }

    @ParameterizedTest
    @CsvSource({"1e308, TOO_FAR", "1e151, TOO_FAST"})
    void what_is_too_fast_for_numbers_leaves_the_world_and_the_others_stay(double speed, Departure.Reason reason) {
        World world = new World(gravity().build());
        ReferenceCase.robust("max-speed")
                .bodies()
                .forEach(body -> world.add(body.vx() == 0 ? body : body.moving(speed, 0)));

        world.step();

        assertThat(world.departures()).containsExactly(new Departure(new BodyId(1), 1, reason));
        assertThat(world.count()).isEqualTo(2);
        run(world, TICKS);
        assertFinite(world);
        assertThat(world.departures()).hasSize(1);
    }

    @Test
    void a_speed_below_the_limit_is_flown() {
        World world = new World(gravity().build());
        ReferenceCase.robust("max-speed")
                .bodies()
                .forEach(body -> world.add(body.vx() == 0 ? body : body.moving(1e149, 0)));

        run(world, TICKS);

        assertThat(world.departures()).isEmpty();
        assertFinite(world);
    }

    @Test
    void a_bullet_beyond_all_numbers_does_not_break_the_walls_or_those_within() {
        World world =
                new World(gravity().contacts(1).walls(Aabb.centred(100, 100), 1).build());
        world.add(BodyDef.asteroid(0, 0, 1, 1).moving(1e308, 1e307));
        world.add(BodyDef.asteroid(10, 0, 1, 1));
        world.add(BodyDef.asteroid(15, 0, 1, 1));

        run(world, TICKS);

        assertThat(world.departures()).hasSize(1);
        assertFinite(world);
    }

    @ParameterizedTest
    @ValueSource(strings = {"nearly-coincident", "denormal", "offset-1e15", "max-speed", "coincident-discs"})
    void a_hard_input_gives_the_same_bits_twice(String id) {
        World one = robust(id, gravity().contacts(0.5));
        World two = robust(id, gravity().contacts(0.5));

        run(one, 30);
        run(two, 30);

        assertThat(one.stateHash()).isEqualTo(two.stateHash());
    }

    @ParameterizedTest
    @ValueSource(longs = {1_000_000_000L, 1_000_000_000_000L})
    void time_is_right_to_its_last_place_after_any_number_of_ticks(long tick) {
        assertThat(WorldSpec.builder().build().timeAt(tick)).isEqualTo(tick / 150.0);
        // A dt that is no n-th part of 1 is meant as it stands: rounded once.
        double odd = 0.37;
        double exact = new BigDecimal(odd).multiply(new BigDecimal(tick)).doubleValue();
        assertThat(WorldSpec.builder().dt(odd).build().timeAt(tick)).isEqualTo(exact);
    }

    @Test
    void a_billion_ticks_are_the_time_of_the_reference() {
        double truth = ReferenceCase.robust("time-1e9-ticks")
                .node("check")
                .get("time_at_1e9_ticks")
                .asDouble();

        assertThat(WorldSpec.builder().build().timeAt(1_000_000_000)).isCloseTo(truth, within(Math.ulp(truth)));
    }

    private static World robust(String id, WorldSpec.Builder laws) {
        return ReferenceCase.robust(id).world(laws.build());
    }

    private static WorldSpec.Builder gravity() {
        return WorldSpec.builder().gravity(1);
    }

    private static WorldSpec.Builder contacts(double restitution) {
        return WorldSpec.builder().contacts(restitution);
    }

    private static World pileOfTen(double dt, Integration integration) {
        World world = new World(contacts(0.5)
                .law(new UniformField(0, -10))
                .walls(new Aabb(-5, 0, 5, 20), 0.5)
                .integration(integration)
                .dt(dt)
                .build());
        for (int i = 0; i < 10; i++) {
            world.add(
                    BodyDef.asteroid(-1 + 0.3 * (i % 3), 0.6 + 1.2 * i, 1, 0.5).moving(0.1 * i, 0));
        }
        return world;
    }

    private static double separation(World world) {
        WorldSnapshot now = world.snapshot();
        return Math.hypot(now.x(1) - now.x(0), now.y(1) - now.y(0));
    }

    private static void assertFinite(World world) {
        WorldSnapshot now = world.snapshot();
        for (int i = 0; i < now.count(); i++) {
            double[] numbers = {now.x(i), now.y(i), now.vx(i), now.vy(i), now.ax(i), now.ay(i)};
            for (double number : numbers) {
                assertThat(number).as("body %d", i).isFinite();
            }
        }
    }
}

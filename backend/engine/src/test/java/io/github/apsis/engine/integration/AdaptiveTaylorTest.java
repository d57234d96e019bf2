package io.github.apsis.engine.integration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.Command;
import io.github.apsis.engine.CommandResult.Rejected;
import io.github.apsis.engine.ReferenceCase;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.diagnostics.Drift;
import io.github.apsis.engine.force.DirectGravity;
import io.github.apsis.engine.force.Forces;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class AdaptiveTaylorTest {
    private static WorldSpec.Builder adaptive(double dt) {
        return WorldSpec.builder().gravity(1).adaptive(1e-16).dt(dt);
    }

    @ParameterizedTest
    @CsvSource({"1e-6", "1e-7", "1e-8", "1e-9", "1e-10"})
    void the_error_falls_at_least_as_fast_as_the_tolerance(double tolerance) {
        ReferenceCase orbit = ReferenceCase.of("kepler-e05-equal");

        double coarse = errorAfterTenOrbits(orbit, tolerance);
        double fine = errorAfterTenOrbits(orbit, 1e-3 * tolerance);

        assertThat(coarse / fine).isGreaterThan(1e3);
    }

    private static double errorAfterTenOrbits(ReferenceCase orbit, double tolerance) {
        World world = orbit.world(
                WorldSpec.builder().gravity(1).adaptive(tolerance).dt(1).build());
        ReferenceCase.run(world, 63);
        return orbit.samples().get(4).positionError(world.snapshot());
    }

    @ParameterizedTest
    @CsvSource({
        "kepler-e05-equal, 628, 6e-13",
        "kepler-e09-equal, 628, 7e-12",
        "kepler-e099-equal, 628, 5e-11",
        "figure8, 633, 5e-12",
        "outer-solar, 1000, 2e-12",
        "triple-moon, 300, 2.8e-8",
        "pythagorean, 50, 2e-5",
        "pythagorean, 60, 1e-3",
        "pythagorean, 70, 2e-2",
    })
    void it_ends_no_farther_from_the_truth_than_ias15(String id, double time, double ias15) {
        ReferenceCase orbit = ReferenceCase.of(id);
        World world = orbit.world(WorldSpec.builder()
                .gravity(orbit.number("G"))
                .adaptive(1e-16)
                .dt(1)
                .build());
        ReferenceCase.run(world, (long) time);

        ReferenceCase.Sample truth = orbit.samples().stream()
                .filter(sample -> sample.time() == time)
                .findFirst()
                .orElseThrow();

        // What REBOUND's IAS15 at its default was measured to reach on the same case.
        assertThat(truth.positionError(world.snapshot()) / orbit.number("length_scale"))
                .isLessThan(ias15);
    }

    @Test
    void ticks_are_read_off_the_path_whatever_their_length() {
        ReferenceCase orbit = ReferenceCase.of("figure8");
        World room = orbit.world(adaptive(1.0 / 150).build());
        World leap = orbit.world(adaptive(63).build());

        ReferenceCase.run(room, 63 * 150);
        ReferenceCase.run(leap, 1);

        // The steps of both are the same but for the rounding of the clock, which the orbit amplifies 448-fold by then.
        for (int i = 0; i < 3; i++) {
            assertThat(room.snapshot().x(i)).isCloseTo(leap.snapshot().x(i), within(1e-13));
            assertThat(room.snapshot().vy(i)).isCloseTo(leap.snapshot().vy(i), within(1e-13));
        }
    }

    @Test
    void an_orbit_is_the_same_a_thousand_million_lengths_from_the_origin() {
        World world = new World(adaptive(1.0 / 150).build());
        world.add(BodyDef.planet(999999999.5, -1e9, 0.5, 0).moving(0, -0.5));
        world.add(BodyDef.planet(1000000000.5, -1e9, 0.5, 0).moving(0, 0.5));

        double worst = 0;
        for (int tick = 0; tick < 9425; tick++) { // ten orbits
            world.step();
            worst = Math.max(worst, Math.abs(world.snapshot().distance(0, 1) - 1));
        }

        assertThat(worst).isLessThan(1e-13); // doubles are 1.2e-7 apart there; the low parts carry the rest
    }

    @Test
    void two_points_that_fall_into_each_other_bounce() {
        World world = new World(adaptive(1.0 / 150).build());
        world.add(BodyDef.planet(-0.5, 0, 0.5, 0));
        world.add(BodyDef.planet(0.5, 0, 0.5, 0));
        double energy = world.conserved().energy().orElseThrow();

        ReferenceCase.run(world, 333); // twice the fall of π/√8 is 2.2214, 333.2 ticks

        assertThat(world.snapshot().x(0))
                .isCloseTo(-0.5, within(1e-5)); // back at rest where it began, 1e-3 of time away
        assertThat(world.conserved().energy().orElseThrow()).isCloseTo(energy, within(1e-7));
        ReferenceCase.run(world, 1500);
        assertThat(world.conserved().energy().orElseThrow()).isCloseTo(energy, within(1e-6));
    }

    @Test
    void a_tick_that_needs_too_many_steps_is_cut_and_counted() {
        Bodies bodies = new Bodies();
        bodies.add(BodyDef.planet(-0.25, 0, 0.5, 0).moving(0, -0.866));
        bodies.add(BodyDef.planet(0.25, 0, 0.5, 0).moving(0, 0.866));
        var integrator = new AdaptiveTaylor(new TaylorStep(1, 0, 0, 0, 1e-16));
        var forces = new Forces(List.of(new DirectGravity(1, 0)));

        integrator.advance(bodies, forces, 1e6);

        assertThat(integrator.lostTime()).isBetween(9e5, 1e6);
        assertThat(Math.hypot(bodies.x(1), bodies.y(1))).isLessThan(0.8); // and the orbit is still one
    }

    @Test
    void it_is_exact_in_a_uniform_field() {
        World world = new World(WorldSpec.builder()
                .law(new UniformField(0, -8))
                .adaptive(1e-16)
                .dt(0.25)
                .build());
        world.add(BodyDef.asteroid(0, 100, 1, 1));

        ReferenceCase.run(world, 16);

        assertThat(world.snapshot().y(0)).isEqualTo(100 - 0.5 * 8 * 16);
        assertThat(world.snapshot().vy(0)).isEqualTo(-32);
    }

    @Test
    void a_softened_pair_keeps_its_energy() {
        World world = new World(adaptive(0.1).softening(0.3).build());
        world.add(BodyDef.planet(-0.5, 0, 0.5, 0).moving(0, -0.1));
        world.add(BodyDef.planet(0.5, 0, 0.5, 0).moving(0, 0.1));
        double energy = world.conserved().energy().orElseThrow();

        ReferenceCase.run(world, 1000);

        assertThat(world.conserved().energy().orElseThrow()).isCloseTo(energy, within(1e-14));
    }

    @Test
    void without_gravity_a_body_flies_on() {
        World world = new World(WorldSpec.builder().adaptive(1e-16).dt(0.25).build());
        world.add(BodyDef.planet(0, 0, 1, 0).moving(1, 0));
        world.add(BodyDef.planet(8, 0, 1, 0).moving(-1, 0.5));

        ReferenceCase.run(world, 100);

        assertThat(world.snapshot().x(0)).isEqualTo(25);
        assertThat(world.snapshot().y(1)).isEqualTo(12.5);
        assertThat(world.lostTime()).isZero();
    }

    @Test
    void what_comes_from_outside_is_booked() {
        World world =
                new World(adaptive(1.0 / 150).law(new UniformField(0.3, -0.2)).build());
        world.add(BodyDef.planet(3, 1, 100, 1).fixed());
        world.add(BodyDef.asteroid(12, 0, 1, 0).moving(0, 3));
        var ship = world.add(BodyDef.ship(0, -20, 1, 1, new ShipLimits(5, 10)));
        world.apply(new Command.SeekTarget(ship, 30, 10));
        Conserved start = world.conserved();

        ReferenceCase.run(world, 600);

        Drift drift = Drift.between(start, world.conserved());
        assertThat(drift.energy().orElseThrow()).isCloseTo(0, within(1e-13));
        assertThat(drift.momentum()).isLessThan(1e-13);
        assertThat(drift.angularMomentum().orElseThrow()).isCloseTo(0, within(1e-13));
    }

    @Test
    void a_body_beyond_all_speed_leaves_the_others_alone() {
        World world = new World(adaptive(1.0 / 150).build());
        world.add(BodyDef.planet(0, 0, 1, 0).moving(1e308, 0));
        world.add(BodyDef.planet(10, 0, 1, 0));
        world.add(BodyDef.planet(11, 0, 1, 0));

        ReferenceCase.run(world, 200);

        assertThat(world.departures()).hasSize(1);
        assertThat(world.snapshot().x(0)).isFinite();
        assertThat(world.snapshot().distance(0, 1)).isLessThan(1);
    }

    @Test
    void contacts_bend_its_path() {
        World world = new World(WorldSpec.builder()
                .law(new UniformField(0, -10))
                .adaptive(1e-16)
                .contacts(1)
                .walls(Aabb.centred(10, 10), 1)
                .build());
        world.add(BodyDef.asteroid(0, 2, 1, 0.5).moving(1.7, 0));
        double energy = world.conserved().energy().orElseThrow();

        ReferenceCase.run(world, 3000);

        // A parabola is drawn exactly. The velocity on it is a difference of positions over a tick, good to 1e-13; a
        // hundred
        // bounces at speed 10 may add up to a hundred times ten times that.
        assertThat(world.conserved().energy().orElseThrow()).isCloseTo(energy, within(1e-10));
    }

    @Test
    void it_sees_what_others_do_to_its_bodies() {
        World world = new World(adaptive(0.5).build());
        var first = world.add(BodyDef.planet(-1, 0, 1, 0).moving(0, -0.5));
        world.add(BodyDef.planet(1, 0, 1, 0).moving(0, 0.5));
        world.step();

        world.apply(new Command.RemoveBody(first));
        WorldSnapshot before = world.snapshot();
        world.step();

        assertThat(world.snapshot().x(0)).isCloseTo(before.x(0) + 0.5 * before.vx(0), within(1e-15));
    }

    @Test
    void it_says_what_it_is_not_made_for() {
        assertThatThrownBy(() -> adaptive(1).law(bodies -> {}).build())
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("choose a symplectic method");
        assertThatThrownBy(() -> adaptive(1).periodic(Aabb.centred(1, 1)).build())
                .isInstanceOf(IllegalStateException.class);
        assertThatThrownBy(() -> WorldSpec.builder().adaptive(1e-17)).isInstanceOf(IllegalArgumentException.class);

        World full = new World(adaptive(1).build());
        for (int i = 0; i < AdaptiveTaylor.MOST_BODIES; i++) {
            full.add(BodyDef.asteroid(3 * i, 0, 1, 1));
        }
        assertThat(full.apply(new Command.AddBody(BodyDef.asteroid(-3, 0, 1, 1))))
                .isInstanceOf(Rejected.class);
    }
}

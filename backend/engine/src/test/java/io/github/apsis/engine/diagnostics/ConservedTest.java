package io.github.apsis.engine.diagnostics;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Vec2;
import org.junit.jupiter.api.Test;

class ConservedTest {
    @Test
    void two_bodies_have_the_sums_that_a_reader_can_check() {
        World world = new World(WorldSpec.builder().gravity(2).build());
        world.add(BodyDef.planet(-1, 0, 3, 0).moving(0, -1));
        world.add(BodyDef.planet(2, 0, 1, 0).moving(0.5, 2));

        Conserved now = world.conserved();

        assertThat(now.kinetic()).isEqualTo(0.5 * 3 * 1 + 0.5 * 1 * 4.25);
        assertThat(now.potential()).hasValue(-2.0 * 3 * 1 / 3);
        assertThat(now.energy()).hasValue(1.5 + 2.125 - 2);
        assertThat(now.momentumX()).isEqualTo(0.5);
        assertThat(now.momentumY()).isEqualTo(-1);
        assertThat(now.angularMomentum()).isEqualTo(3 * -1 * -1 + 1 * 2 * 2.0);
        assertThat(now.centreOfMass()).contains(new Vec2(-0.25, 0));
        assertThat(now.virialRatio()).hasValue(2 * 3.625 / 2);
        assertThat(now.coincidentPairs()).isZero();
    }

    @Test
    void a_circular_orbit_is_in_virial_equilibrium() {
        World world = new World(WorldSpec.builder().gravity(1).build());
        world.add(BodyDef.planet(-0.5, 0, 0.5, 0).moving(0, -0.5));
        world.add(BodyDef.planet(0.5, 0, 0.5, 0).moving(0, 0.5));

        assertThat(world.conserved().virialRatio().orElseThrow()).isCloseTo(1, within(1e-15));
    }

    @Test
    void without_gravity_there_is_no_virial_ratio_and_without_mass_no_centre() {
        World world = new World(WorldSpec.builder().build());
        world.add(BodyDef.planet(3, 4, 0, 0).moving(1, 0));

        Conserved now = world.conserved();

        assertThat(now.virialRatio()).isEmpty();
        assertThat(now.centreOfMass()).isEmpty();
        assertThat(now.energy()).hasValue(0);
    }

    @Test
    void a_world_that_repeats_itself_has_no_centre() {
        World world =
                new World(WorldSpec.builder().periodic(Aabb.centred(10, 10)).build());
        world.add(BodyDef.planet(3, 4, 1, 0).moving(100, 0));
        Conserved then = world.conserved();

        run(world, 150);

        assertThat(then.centreOfMass()).isEmpty();
        Drift drift = Drift.between(then, world.conserved());
        assertThat(drift.angularMomentum()).isEmpty();
        assertThat(drift.momentum()).isZero();
    }

    @Test
    void bodies_in_one_place_are_counted_in_pairs() {
        World world = new World(WorldSpec.builder().gravity(1).build());
        for (int i = 0; i < 3; i++) {
            world.add(BodyDef.planet(0.1, 0.1, 1, 0)); // three pairs
        }
        world.add(BodyDef.planet(0.1, Math.nextUp(0.1), 1, 0)); // next to them
        world.add(BodyDef.planet(0, 0, 1, 0));
        world.add(BodyDef.planet(1e-160, 0, 1, 0)); // too near for gravity: one pair

        assertThat(world.conserved().coincidentPairs()).isEqualTo(4);
    }

    @Test
    void an_energy_beyond_the_numbers_is_none() {
        World world = new World(WorldSpec.builder().gravity(1).build());
        world.add(BodyDef.planet(0, 0, 1e300, 0).moving(1e100, 0));
        world.add(BodyDef.planet(1, 0, 1e300, 0).moving(-1e100, 0));

        Conserved now = world.conserved();

        assertThat(now.kinetic()).isInfinite();
        assertThat(now.energy()).isEmpty();
        assertThat(now.virialRatio()).isEmpty();
        assertThat(Drift.between(now, now).momentum()).isNotNaN();
    }
}

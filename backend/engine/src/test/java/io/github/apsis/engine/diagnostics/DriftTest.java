package io.github.apsis.engine.diagnostics;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.Command;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.force.ForceLaw;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import org.junit.jupiter.api.Test;

/** What is done by right is in the books, so it is no drift; each test would fail by orders without them. */
class DriftTest {
    @Test
    void a_cluster_keeps_its_angular_momentum() {
        Drift drift = drift(cluster(WorldSpec.builder().gravity(1).softening(0.1)), 1500);

        assertThat(drift.angularMomentum().orElseThrow()).isCloseTo(0, within(1e-14)); // rounding
        assertThat(drift.momentum()).isCloseTo(0, within(1e-14));
        assertThat(drift.energy().orElseThrow()).isCloseTo(0, within(1e-3)); // Verlet, close encounters
    }

    @Test
    void walls_turn_what_hits_them_by_right() {
        Drift drift = drift(cluster(WorldSpec.builder().walls(new Aabb(-8, -8, 14, 12), 0.9)), 1500);

        assertThat(drift.angularMomentum().orElseThrow()).isCloseTo(0, within(1e-13));
        assertThat(drift.momentum()).isCloseTo(0, within(1e-13));
    }

    @Test
    void a_fixed_sun_holds_its_planets_by_right() {
        World world = new World(WorldSpec.builder().gravity(16).build());
        world.add(BodyDef.planet(10, 5, 1000, 1).fixed());
        world.add(BodyDef.asteroid(60, 5, 3, 1).moving(0, 20));
        world.add(BodyDef.asteroid(10, 85, 3, 1).moving(14, 0));

        Drift drift = drift(world, 1500);

        assertThat(drift.angularMomentum().orElseThrow()).isCloseTo(0, within(1e-13));
        assertThat(drift.momentum()).isCloseTo(0, within(1e-13));
    }

    @Test
    void engines_turn_their_ships_by_right() {
        World world = new World(WorldSpec.builder().contacts(0.5).seed(3).build());
        for (int i = 0; i < 6; i++) {
            world.add(BodyDef.ship(20 * i, 10, 12, 8, new ShipLimits(120, 2400)));
        }
        world.apply(new Command.SeekTarget(new BodyId(1), -200, 300));

        Drift drift = drift(world, 1500);

        assertThat(drift.angularMomentum().orElseThrow()).isCloseTo(0, within(1e-13));
        assertThat(drift.momentum()).isCloseTo(0, within(1e-13));
    }

    @Test
    void a_field_pulls_by_right() {
        World world = new World(
                WorldSpec.builder().gravity(1).law(new UniformField(3, -10)).build());
        world.add(BodyDef.planet(5, 0, 100, 1).moving(0, 1));
        world.add(BodyDef.planet(9, 0, 1, 1).moving(0, -4));
        world.add(BodyDef.planet(-40, 20, 50, 1).fixed());

        Drift drift = drift(world, 1500);

        assertThat(drift.angularMomentum().orElseThrow()).isCloseTo(0, within(1e-13));
        assertThat(drift.momentum()).isCloseTo(0, within(1e-13));
    }

    @Test
    void a_pile_on_the_floor_is_held_by_right() {
        World world = new World(WorldSpec.builder()
                .law(new UniformField(0, -10))
                .contacts(0.5)
                .walls(new Aabb(-8, 0, 8, 100), 0.5)
                .build());
        for (int i = 0; i < 30; i++) {
            world.add(BodyDef.asteroid(-6 + 1.3 * (i % 10), 1 + 1.3 * (i / 10), 0.2 + 0.01 * i, 0.5));
        }

        run(world, 1500);

        // At rest there is no momentum to measure against: but the field has passed 1000 on in these ten seconds.
        Conserved now = world.conserved();
        assertThat(now.momentumY() - now.booked().momentumY()).isCloseTo(0, within(1e-12));
        assertThat(now.angularMomentum() - now.booked().angularMomentum()).isCloseTo(0, within(1e-12));
    }

    @Test
    void bodies_that_part_while_they_move_change_angular_momentum_by_right() {
        World world = new World(WorldSpec.builder().contacts(1).build());
        world.add(BodyDef.asteroid(0, 0, 1, 1).moving(0, 1));
        world.add(BodyDef.asteroid(1, 0, 2, 1).moving(0.1, -1)); // in each other, and passing

        Drift drift = drift(world, 300);

        assertThat(drift.angularMomentum().orElseThrow()).isCloseTo(0, within(1e-13));
        assertThat(drift.momentum()).isCloseTo(0, within(1e-15));
    }

    @Test
    void a_law_without_potential_leaves_energy_open() {
        ForceLaw drag = bodies -> bodies.accelerate(0, -bodies.vx(0), -bodies.vy(0));
        World world = new World(WorldSpec.builder().law(drag).build());
        world.add(BodyDef.planet(0, 0, 1, 0).moving(1, 0));

        Drift drift = drift(world, 150);

        assertThat(drift.energy()).isEmpty();
        assertThat(drift.momentum()).isGreaterThan(0.5); // an unknown law is not excused
    }

    private static Drift drift(World world, int ticks) {
        Conserved then = world.conserved();
        run(world, ticks);
        return Drift.between(then, world.conserved());
    }

    private static World cluster(WorldSpec.Builder laws) {
        World world = new World(laws.build());
        var rng = new Rng(21);
        for (int i = 0; i < 30; i++) {
            world.add(BodyDef.asteroid(rng.between(-5, 10), rng.between(-5, 10), rng.between(0.5, 2), 0.2)
                    .moving(rng.between(-2, 2), rng.between(-2, 2)));
        }
        return world;
    }
}

package io.github.apsis.engine.collision;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.Command;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import io.github.apsis.engine.steering.SteeringSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ContactsTest {
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.25, 0.5, 0.8, 1})
    void a_head_on_pair_leaves_with_exactly_its_share_of_the_closing_speed(double e) {
        World world = new World(WorldSpec.builder().contacts(e).build());
        world.add(BodyDef.asteroid(-2, 0, 1, 0.5).moving(2, 0));
        world.add(BodyDef.asteroid(1, 0, 3, 0.75).moving(-0.5, 0));

        run(world, 300);

        WorldSnapshot now = world.snapshot();
        assertThat(now.vx(1) - now.vx(0)).isCloseTo(e * 2.5, within(1e-15)); // closing speed 2.5
        assertThat(now.vx(0) + 3 * now.vx(1)).isCloseTo(0.5, within(1e-15)); // momentum
    }

    @Test
    void nothing_happens_between_bodies_that_separate() {
        World world = new World(WorldSpec.builder().contacts(1).build());
        world.add(BodyDef.asteroid(0, 0, 1, 1).moving(-1, 0));
        world.add(BodyDef.asteroid(2, 0, 1, 1).moving(1, 0));

        run(world, 10);

        assertThat(world.snapshot().vx(0)).isEqualTo(-1);
        assertThat(world.snapshot().vx(1)).isEqualTo(1);
    }

    @Test
    void a_fixed_body_stays_and_the_other_bounces_off_it() {
        World world = new World(WorldSpec.builder().contacts(0.5).build());
        world.add(BodyDef.planet(0, 0, 1, 1).fixed());
        world.add(BodyDef.asteroid(-5, 0, 1, 1).moving(10, 0));

        run(world, 150);

        WorldSnapshot now = world.snapshot();
        assertThat(now.x(0)).isZero();
        assertThat(now.vx(1)).isCloseTo(-5, within(1e-14));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e2, 1e4, 1e6, 1e8})
    void nothing_is_so_fast_that_it_tunnels(double speed) {
        World world = new World(WorldSpec.builder().contacts(1).build());
        world.add(BodyDef.asteroid(-30, 0, 1, 0.1).moving(speed, 0));
        world.add(BodyDef.asteroid(10, 0, 1, 0.1));

        run(world, 150);

        assertThat(world.snapshot().vx(0)).isCloseTo(0, within(1e-13 * speed)); // equal masses swap velocities
        assertThat(world.snapshot().vx(1)).isCloseTo(speed, within(1e-13 * speed));
    }

    @Test
    void a_bullet_between_two_walls_of_a_box_never_leaves_it() {
        World world = new World(WorldSpec.builder().walls(Aabb.centred(5, 5), 1).build());
        world.add(BodyDef.asteroid(0, 0, 1, 1).moving(3e4, 1.7e4)); // some 25 bounces a tick

        for (int tick = 0; tick < 1000; tick++) {
            world.step();
            WorldSnapshot now = world.snapshot();
            assertThat(Math.abs(now.x(0))).isLessThan(4 + 1e-6);
            assertThat(Math.abs(now.y(0))).isLessThan(4 + 1e-6);
        }
    }

    @Test
    void bodies_meet_across_the_seam_of_a_periodic_world() {
        World world = new World(
                WorldSpec.builder().contacts(1).periodic(Aabb.centred(10, 10)).build());
        world.add(BodyDef.asteroid(9, 0, 1, 0.5).moving(1, 0));
        world.add(BodyDef.asteroid(-8, 0, 1, 0.5).moving(-1, 0)); // three away, the short way round

        run(world, 300);

        assertThat(world.snapshot().vx(0)).isCloseTo(-1, within(1e-14));
        assertThat(world.snapshot().vx(1)).isCloseTo(1, within(1e-14));
    }

    @Test
    void touching_balls_hand_the_whole_velocity_to_the_last() {
        World world = new World(WorldSpec.builder().contacts(1).build());
        world.add(BodyDef.asteroid(-1, 0, 1, 0.1).moving(1, 0));
        for (int i = 0; i < 20; i++) {
            world.add(BodyDef.asteroid(0.2 * i, 0, 1, 0.1));
        }

        run(world, 150);

        WorldSnapshot now = world.snapshot();
        assertThat(now.vx(20)).isCloseTo(1, within(1e-9));
        for (int i = 0; i < 20; i++) {
            assertThat(now.vx(i)).isCloseTo(0, within(1e-9));
        }
    }

    @Test
    void momentum_stays_through_ten_thousand_ticks_of_gravity_and_collisions() {
        World world = new World(WorldSpec.builder().gravity(1).contacts(0.8).build());
        long seed = 21;
        var rng = new Rng(seed);
        for (int i = 0; i < 49; i++) {
            world.add(BodyDef.asteroid(3 * (i % 7), 3 * (i / 7), rng.between(0.5, 2), rng.between(0.4, 1))
                    .moving(rng.between(-1, 1), rng.between(-1, 1)));
        }
        var before = world.conserved();

        run(world, 10_000);

        var after = world.conserved();
        double error = Math.hypot(after.momentumX() - before.momentumX(), after.momentumY() - before.momentumY());
        assertThat(error / after.momentumScale()).as("seed %d", seed).isLessThan(1e-12);
    }

    @Test
    void an_elastic_gas_keeps_its_energy_and_stays_in_its_box() {
        World world = new World(
                WorldSpec.builder().contacts(1).walls(Aabb.centred(20, 20), 1).build());
        long seed = 8;
        var rng = new Rng(seed);
        for (int i = 0; i < 400; i++) {
            world.add(
                    BodyDef.asteroid(-19 + 2 * (i % 20), -19 + 2 * (i / 20), rng.between(0.5, 2), rng.between(0.2, 0.9))
                            .moving(rng.between(-5, 5), rng.between(-5, 5)));
        }
        double before = world.conserved().kinetic();

        double deepest = 0;
        for (int tick = 0; tick < 500; tick++) {
            world.step();
            deepest = Math.max(deepest, deepestOverlap(world.snapshot()));
        }

        // Some 10⁴ collisions, each exact to a few roundings.
        assertThat(world.conserved().kinetic() / before - 1).as("seed %d", seed).isCloseTo(0, within(1e-12));
        assertThat(deepest).as("deepest overlap in radii, seed %d", seed).isLessThan(1e-9);
    }

    @Test
    void what_restitution_takes_stands_in_the_ledger() {
        World world = new World(WorldSpec.builder()
                .gravity(5)
                .contacts(0.3)
                .walls(Aabb.centred(10, 10), 0.6)
                .build());
        long seed = 2;
        var rng = new Rng(seed);
        for (int i = 0; i < 36; i++) {
            world.add(BodyDef.asteroid(-7 + 2.8 * (i % 6), -7 + 2.8 * (i / 6), 1, 0.5)
                    .moving(rng.between(-6, 6), rng.between(-6, 6)));
        }
        double before = world.conserved().energy().orElseThrow();

        run(world, 1500);

        double after = world.conserved().energy().orElseThrow();
        double lost = world.ledger().energy();
        assertThat(lost).isLessThan(-0.3 * Math.abs(before)); // much is lost
        // What the books do not explain is the error of the integrator and of contact times under a changing force:
        // 0.8e-4
        // to 1.6e-4 of what is lost for the seeds 1 to 8, always a little more lost than booked.
        assertThat((after - before - lost) / lost).as("seed %d", seed).isCloseTo(0, within(3e-4));
    }

    @Test
    void a_bounce_under_thrust_leaves_the_books_in_order() {
        World world = new World(WorldSpec.builder()
                .seed(3)
                .contacts(0.5)
                .steering(SteeringSpec.DEFAULT.avoiding(SteeringSpec.Avoidance.NONE)) // or it would fly round the wall
                .build());
        long ship = world.add(BodyDef.ship(-100, 0, 12, 8, new ShipLimits(120, 2400)))
                .value();
        for (int i = 0; i < 40; i++) {
            world.add(BodyDef.asteroid(30 + 20 * (i % 4), -90 + 20 * (i / 4), 5, 9)); // a wall without a gap
        }
        world.apply(new Command.SeekTarget(new BodyId(ship), 400, 0));
        double before = world.conserved().kinetic();

        run(world, 1500);

        // Without other forces every joule is thrust's or a contact's: what is left is rounding.
        double change = world.conserved().kinetic() - before - world.ledger().energy();
        assertThat(change / world.conserved().kinetic()).isCloseTo(0, within(1e-12));
    }

    private static double deepestOverlap(WorldSnapshot now) {
        double deepest = 0;
        for (int i = 0; i < now.count(); i++) {
            for (int j = i + 1; j < now.count(); j++) {
                double gap = Math.hypot(now.x(j) - now.x(i), now.y(j) - now.y(i)) - now.radius(i) - now.radius(j);
                deepest = Math.max(deepest, -gap / Math.min(now.radius(i), now.radius(j)));
            }
        }
        return deepest;
    }
}

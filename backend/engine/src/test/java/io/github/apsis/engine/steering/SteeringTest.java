package io.github.apsis.engine.steering;

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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SteeringTest {
    private static final ShipLimits LIMITS = new ShipLimits(120, 2400);
    private static final double MASS = 12;

    @ParameterizedTest
    @ValueSource(doubles = {5, 50, 300, 1000})
    void a_ship_arrives_and_stops_without_overshooting(double distance) {
        World world = new World(WorldSpec.builder().build());
        BodyId ship = world.add(ship(0, 0));
        world.apply(new Command.SeekTarget(ship, distance, 0));

        double furthest = 0;
        for (int tick = 0; tick < 150 * 20; tick++) {
            world.step();
            furthest = Math.max(furthest, world.snapshot().x(0));
        }

        WorldSnapshot now = world.snapshot();
        assertThat(now.x(0)).isCloseTo(distance, within(0.001));
        assertThat(Math.hypot(now.vx(0), now.vy(0))).isLessThan(0.001);
        assertThat(furthest).isLessThan(distance + 0.05);
    }

    @Test
    void a_ship_stops_at_a_target_in_the_field_of_a_planet() {
        World world = new World(WorldSpec.builder().gravity(16).contacts(0.8).build());
        world.add(BodyDef.planet(0, 0, 60_000, 34).fixed());
        BodyId ship = world.add(ship(-400, 0));
        world.apply(new Command.SeekTarget(ship, 0, 200)); // gravity there is 24 of the 200 that the engine has

        run(world, 150 * 15);

        WorldSnapshot now = world.snapshot();
        assertThat(Math.hypot(now.x(1), now.y(1) - 200)).isLessThan(0.1);
        assertThat(Math.hypot(now.vx(1), now.vy(1))).isLessThan(0.1);
    }

    @Test
    void thrust_never_exceeds_the_engine_and_never_lifts_a_ship_over_its_top_speed() {
        World world = new World(WorldSpec.builder()
                .seed(3)
                .contacts(0.8)
                .walls(Aabb.centred(300, 300), 0.8)
                .build());
        for (int i = 0; i < 20; i++) {
            world.add(ship(-250 + 50 * (i % 10), 20 * (i / 10)));
        }

        for (int tick = 0; tick < 1500; tick++) {
            world.step();
            WorldSnapshot now = world.snapshot();
            for (int i = 0; i < now.count(); i++) {
                assertThat(now.thrust(i)).isLessThanOrEqualTo(1 + 1e-12);
                // Contacts can throw a ship above its top speed; in this quiet crowd none does.
                assertThat(Math.hypot(now.vx(i), now.vy(i))).isLessThan(120 + 1e-9);
            }
        }
    }

    @Test
    void two_ships_that_fly_at_each_other_pass_without_touching() {
        World world = new World(WorldSpec.builder().contacts(0.8).build());
        BodyId left = world.add(ship(-400, 0));
        BodyId right = world.add(ship(400, 0));
        world.apply(new Command.SeekTarget(left, 400, 0));
        world.apply(new Command.SeekTarget(right, -400, 0));

        double closest = Double.MAX_VALUE;
        for (int tick = 0; tick < 150 * 20; tick++) {
            world.step();
            WorldSnapshot now = world.snapshot();
            closest = Math.min(closest, Math.hypot(now.x(0) - now.x(1), now.y(0) - now.y(1)) - 16);
        }

        assertThat(closest).isGreaterThan(1);
        assertThat(world.snapshot().x(0)).isCloseTo(400, within(0.1));
        assertThat(world.snapshot().x(1)).isCloseTo(-400, within(0.1));
    }

    @Test
    void a_ship_flies_round_a_rock_on_its_way() {
        World world = new World(WorldSpec.builder().contacts(0.8).build());
        BodyId ship = world.add(ship(-300, 0));
        world.add(BodyDef.asteroid(0, 2, 1e9, 40));
        world.apply(new Command.SeekTarget(ship, 300, 0));

        double closest = Double.MAX_VALUE;
        for (int tick = 0; tick < 150 * 12; tick++) {
            world.step();
            WorldSnapshot now = world.snapshot();
            closest = Math.min(closest, Math.hypot(now.x(0) - now.x(1), now.y(0) - now.y(1)) - 48);
        }

        assertThat(closest).isGreaterThan(1);
        assertThat(world.snapshot().x(0)).isCloseTo(300, within(0.1));
    }

    @Test
    void a_ship_sees_a_rock_across_the_seam() {
        World world = new World(WorldSpec.builder()
                .contacts(0.8)
                .periodic(Aabb.centred(500, 500))
                .build());
        world.add(ship(350, 0).moving(72, 0)); // its heading leads through the seam
        world.add(BodyDef.asteroid(-450, 2, 1e9, 30)); // 200 ahead

        double closest = Double.MAX_VALUE;
        for (int tick = 0; tick < 150 * 4; tick++) {
            world.step();
            WorldSnapshot now = world.snapshot();
            double dx = Math.IEEEremainder(now.x(0) - now.x(1), 1000);
            closest = Math.min(closest, Math.hypot(dx, now.y(0) - now.y(1)) - 38);
        }

        assertThat(closest).isGreaterThan(1);
    }

    @Test
    void a_wanderer_turns_smoothly_and_stays_off_the_walls() {
        World world = new World(
                WorldSpec.builder().seed(9).walls(Aabb.centred(400, 400), 0.8).build());
        world.add(ship(0, 0).moving(72, 0));

        double sharpest = 0;
        double furthest = 0;
        for (int tick = 0; tick < 150 * 120; tick++) {
            WorldSnapshot before = world.snapshot();
            world.step();
            WorldSnapshot now = world.snapshot();
            double turn = Math.abs(Math.atan2(
                    before.vx(0) * now.vy(0) - before.vy(0) * now.vx(0),
                    before.vx(0) * now.vx(0) + before.vy(0) * now.vy(0)));
            sharpest = Math.max(sharpest, turn);
            furthest = Math.max(furthest, Math.max(Math.abs(now.x(0)), Math.abs(now.y(0))));
        }

        // The engine can turn the velocity at cruise speed by a·dt/v = 200/150/72 = 0.0185 a tick, and more when slow.
        assertThat(sharpest).isLessThan(0.06);
        assertThat(furthest).isLessThan(392 - 1);
    }

    @Test
    void a_wanderer_paths_do_not_depend_on_the_others() {
        World alone = wanderers(1);
        World together = wanderers(2);

        run(alone, 1000);
        run(together, 1000);

        assertThat(together.snapshot().x(0)).isEqualTo(alone.snapshot().x(0));
    }

    private static World wanderers(int count) {
        World world = new World(WorldSpec.builder().seed(1).build());
        for (int i = 0; i < count; i++) {
            world.add(ship(10_000 * i, 0)); // out of each other's sight
        }
        return world;
    }

    private static BodyDef ship(double x, double y) {
        return BodyDef.ship(x, y, MASS, 8, LIMITS);
    }
}

package io.github.apsis.engine.collision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.Command;
import io.github.apsis.engine.CommandResult.Reason;
import io.github.apsis.engine.CommandResult.Rejected;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.diagnostics.Drift;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class BornInWallTest {
    private static final double ROUNDING = 1e-12;

    /** The ways to find contacts. */
    enum Contacts {
        TICK,
        EXACT,
        SERIES;

        WorldSpec.Builder in(WorldSpec.Builder laws) {
            return switch (this) {
                case TICK -> laws.contacts(0.5);
                case EXACT -> laws.exactContacts(0.5);
                case SERIES -> laws.adaptive(1e-14).exactContacts(0.5);
            };
        }
    }

    @ParameterizedTest
    @EnumSource
    void a_body_in_a_wall_is_pushed_out_no_faster_than_ten_radii_per_time_and_gains_no_speed(Contacts contacts) {
        World world = new World(contacts.in(WorldSpec.builder())
                .walls(Aabb.centred(100, 50), 0.5)
                .build());
        world.add(BodyDef.planet(99.7, 10, 3, 1)); // 0.7 of it in the wall
        world.add(BodyDef.planet(-90, -49.2, 3, 1));

        double x = 99.7;
        for (int tick = 0; tick < 300; tick++) {
            world.step();
            WorldSnapshot now = world.snapshot();
            assertThat(x - now.x(0)).isBetween(-ROUNDING, 10.0 / 150 + ROUNDING);
            assertThat(now.vx(0)).isZero();
            assertThat(now.vy(1)).isZero();
            x = now.x(0);
        }

        assertThat(x).isCloseTo(99, within(1e-6)); // overlaps below 1e-7 of a radius are rounding
        assertThat(world.snapshot().y(1)).isCloseTo(-49, within(1e-6));
    }

    @ParameterizedTest
    @EnumSource
    void what_pushing_out_lifts_against_a_field_is_booked(Contacts contacts) {
        World world = new World(contacts.in(WorldSpec.builder())
                .law(new UniformField(0, -10))
                .walls(Aabb.centred(100, 50), 0.5)
                .build());
        world.add(BodyDef.planet(0, -49.5, 3, 1)); // m g h = 3 · 10 · 0.5 to be lifted
        var start = world.conserved();

        for (int tick = 0; tick < 300; tick++) {
            world.step();
        }

        assertThat(world.snapshot().y(0)).isCloseTo(-49, within(1e-3)); // at rest on the floor
        assertThat(Drift.between(start, world.conserved()).energy().orElseThrow())
                .isCloseTo(0, within(1e-12));
    }

    @Test
    void a_settled_heap_can_be_put_into_a_new_world_body_by_body() {
        WorldSpec laws = WorldSpec.builder()
                .contacts(0.2)
                .law(new UniformField(0, -100))
                .walls(Aabb.centred(20, 40), 0.2)
                .build();
        World heap = new World(laws);
        var rng = new Rng(3);
        for (int i = 0; i < 100; i++) {
            heap.add(BodyDef.asteroid(-18 + 4 * (i % 10) + rng.between(-0.5, 0.5), -38 + 4 * (i / 10), 1, 1.4));
        }
        for (int tick = 0; tick < 900; tick++) {
            heap.step();
        }
        WorldSnapshot settled = heap.snapshot();

        World again = new World(laws);
        int inWalls = 0;
        for (int i = 0; i < settled.count(); i++) {
            again.add(BodyDef.asteroid(settled.x(i), settled.y(i), 1, 1.4).moving(settled.vx(i), settled.vy(i)));
            inWalls += laws.boundary().holds(settled.x(i), settled.y(i), 1.4) ? 0 : 1;
        }
        for (int tick = 0; tick < 150; tick++) {
            again.step();
        }

        assertThat(inWalls).as("what lies on the floor lies a little in it").isPositive();
        for (int i = 0; i < settled.count(); i++) {
            assertThat(again.snapshot().y(i)).isCloseTo(settled.y(i), within(0.02)); // 2 % of a radius may be left
        }
    }

    @Test
    void a_centre_beyond_a_wall_and_a_body_that_fits_nowhere_are_refused() {
        World world = new World(
                WorldSpec.builder().contacts(1).walls(Aabb.centred(100, 50), 1).build());
        World wedge = new World(WorldSpec.builder()
                .contacts(1)
                .halfPlanes(List.of(new Boundary.HalfPlane(0.6, 0.8, 0), new Boundary.HalfPlane(-0.6, 0.8, 0)), 1)
                .build());

        for (BodyDef body : List.of(
                BodyDef.planet(100.001, 0, 1, 1), BodyDef.planet(0, -50.001, 1, 0), BodyDef.planet(0, 0, 1, 50.001))) {
            assertThat(world.apply(new Command.AddBody(body))).isEqualTo(new Rejected(Reason.OUTSIDE_WORLD));
        }
        assertThat(wedge.apply(new Command.AddBody(BodyDef.planet(0, -0.001, 1, 1))))
                .isEqualTo(new Rejected(Reason.OUTSIDE_WORLD));
    }
}

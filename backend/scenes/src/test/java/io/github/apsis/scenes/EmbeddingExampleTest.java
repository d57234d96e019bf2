package io.github.apsis.scenes;

// example begins
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;
import org.junit.jupiter.api.Test;

class EmbeddingExampleTest {
    private static final double G = 16; // length³ / (mass · time²)
    private static final double SUN_MASS = 60_000;
    private static final double RADIUS = 200; // of the orbit, length

    @Test
    void a_moon_on_a_circle_comes_back_after_one_period() {
        World world = new World(WorldSpec.builder().gravity(G).contacts(0.8).build());
        world.add(BodyDef.planet(0, 0, SUN_MASS, 34).fixed());
        double speed = Math.sqrt(G * SUN_MASS / RADIUS);
        BodyId moon = world.add(BodyDef.planet(RADIUS, 0, 1, 5).moving(0, speed));

        double period = 2 * Math.PI * RADIUS / speed;
        while (world.time() < period) {
            world.step();
        }

        WorldSnapshot now = world.snapshot();
        int i = now.indexOf(moon);
        double distance = Math.sqrt(now.x(i) * now.x(i) + now.y(i) * now.y(i));
        assertThat(distance).isCloseTo(RADIUS, within(0.01)); // the integrator's error is of order (n dt)²
        assertThat(now.y(i))
                .isCloseTo(0, within(speed / 150)); // one tick's way: the period is no whole number of ticks
    }

    @Test
    void two_equal_discs_that_meet_head_on_part_with_four_fifths_of_their_speed() {
        World world = new World(WorldSpec.builder().contacts(0.8).build());
        BodyId left = world.add(BodyDef.asteroid(-50, 0, 2, 10).moving(30, 0));
        BodyId right = world.add(BodyDef.asteroid(50, 0, 2, 10).moving(-30, 0));

        for (int tick = 0; tick < 300; tick++) {
            world.step();
        }

        WorldSnapshot now = world.snapshot();
        assertThat(now.vx(now.indexOf(left))).isCloseTo(-24, within(1e-12));
        assertThat(now.vx(now.indexOf(right))).isCloseTo(24, within(1e-12));
        assertThat(world.ledger().energy())
                .isCloseTo(2 * (24 * 24 - 30 * 30), within(1e-9)); // Σ m v² / 2, what was lost
    }
}
// example ends

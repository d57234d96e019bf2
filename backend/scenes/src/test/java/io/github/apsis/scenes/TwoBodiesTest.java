package io.github.apsis.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import org.junit.jupiter.api.Test;

class TwoBodiesTest {
    private static final int TICKS_PER_PERIOD = 1500; // 10 s of 150 ticks

    private final World world = new TwoBodies().world(0);

    @Test
    void after_ten_seconds_both_are_back_where_they_began() {
        WorldSnapshot start = world.snapshot();

        step(TICKS_PER_PERIOD);

        // Rounding alone: 1e-13 of 200 units after 1500 ticks, at 163 units a second.
        for (int i = 0; i < 2; i++) {
            assertThat(world.snapshot().x(i)).isCloseTo(start.x(i), within(1e-10));
            assertThat(world.snapshot().y(i)).isCloseTo(start.y(i), within(1e-10));
        }
    }

    @Test
    void half_way_they_are_a_plus_ae_apart() {
        step(TICKS_PER_PERIOD / 2);

        WorldSnapshot now = world.snapshot();
        assertThat(now.x(0) - now.x(1)).isCloseTo(300, within(1e-10)); // a (1 + e)
        assertThat(now.y(0) - now.y(1)).isCloseTo(0, within(1e-10));
    }

    @Test
    void their_energy_is_that_of_the_ellipse_and_stays() {
        double energy = -world.spec().gravity() * 3000 * 1000 / (2 * TwoBodies.SEMI_MAJOR_AXIS);
        assertThat(world.conserved().energy().orElseThrow() / energy).isCloseTo(1, within(1e-14));

        step(100 * TICKS_PER_PERIOD);

        // A walk of roundings through a hundred revolutions; IAS15 of REBOUND walks 2e-15.
        assertThat(world.conserved().energy().orElseThrow() / energy).isCloseTo(1, within(1e-13));
    }

    @Test
    void momentum_stays_zero_and_angular_momentum_stays() {
        double spin = world.conserved().angularMomentum();

        step(10 * TICKS_PER_PERIOD);

        // Rounding of 15 000 ticks, as a random walk: √15000 · 1e-16 of what moves, with a margin of 10.
        assertThat(Math.abs(world.conserved().momentumX()) / world.conserved().momentumScale())
                .isLessThan(1e-13);
        assertThat(Math.abs(world.conserved().momentumY()) / world.conserved().momentumScale())
                .isLessThan(1e-13);
        assertThat(world.conserved().angularMomentum() / spin).isCloseTo(1, within(1e-12));
    }

    private void step(int ticks) {
        for (int i = 0; i < ticks; i++) {
            world.step();
        }
    }
}

package io.github.apsis.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import org.junit.jupiter.api.Test;

class FigureEightTest {
    private static final int TICKS_PER_PERIOD = 949; // 6.32591398 s · 150 = 948.89

    private final World world = new FigureEight().world(0);

    @Test
    void after_one_period_the_three_are_back_where_they_began() {
        WorldSnapshot start = world.snapshot();

        step(TICKS_PER_PERIOD);

        // The period is 0.11 of a tick short of 949, at up to 260 units a second: 0.19 units.
        for (int i = 0; i < 3; i++) {
            assertThat(world.snapshot().x(i)).isCloseTo(start.x(i), within(0.2));
            assertThat(world.snapshot().y(i)).isCloseTo(start.y(i), within(0.2));
        }
    }

    @Test
    void a_third_of_a_period_later_each_stands_where_another_stood() {
        WorldSnapshot start = world.snapshot();

        step(316); // 948.89 / 3 = 316.3

        assertThat(nearest(world.snapshot(), start.x(0), start.y(0))).isLessThan(1); // 0.3 ticks at 260 units a second
        assertThat(nearest(world.snapshot(), start.x(1), start.y(1))).isLessThan(1);
        assertThat(nearest(world.snapshot(), start.x(2), start.y(2))).isLessThan(1);
    }

    @Test
    void the_eight_is_stable_it_still_is_one_after_fifty_periods() {
        step(50 * TICKS_PER_PERIOD);

        WorldSnapshot now = world.snapshot();
        for (int i = 0; i < 3; i++) {
            assertThat(Math.abs(now.x(i))).isLessThan(222); // the eight reaches to 1.08 · 200, plus some tick
            assertThat(Math.abs(now.y(i))).isLessThan(75); // and to 0.35 · 200
        }
    }

    private static double nearest(WorldSnapshot now, double x, double y) {
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < now.count(); i++) {
            double dx = now.x(i) - x;
            double dy = now.y(i) - y;
            nearest = Math.min(nearest, Math.sqrt(dx * dx + dy * dy));
        }
        return nearest;
    }

    private void step(int ticks) {
        for (int i = 0; i < ticks; i++) {
            world.step();
        }
    }
}

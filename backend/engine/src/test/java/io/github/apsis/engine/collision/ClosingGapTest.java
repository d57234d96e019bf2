package io.github.apsis.engine.collision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.math.Rng;
import org.junit.jupiter.api.Test;

class ClosingGapTest {
    @Test
    void a_gap_that_closes_under_the_full_acceleration_is_met_in_one_step() {
        // 1.25 + 10 t − 5 t² = 0 at t = (10 + √125)/10
        assertThat(ClosingGap.safeTime(1.25, 10, 10)).isCloseTo(1 + Math.sqrt(1.25), within(1e-15));
        assertThat(ClosingGap.safeTime(1.25, -10, 10)).isCloseTo(Math.sqrt(1.25) - 1, within(1e-15));
    }

    @Test
    void without_acceleration_it_is_newtons_step() {
        assertThat(ClosingGap.safeTime(3, -2, 0)).isEqualTo(1.5);
        assertThat(ClosingGap.safeTime(3, 2, 0)).isInfinite();
        assertThat(ClosingGap.safeTime(3, 0, 0)).isInfinite();
        assertThat(ClosingGap.safeTime(0, 0, 0)).isInfinite();
        assertThat(ClosingGap.safeTime(0, 0, 1)).isZero();
    }

    @Test
    void partners_that_touch_and_separate_are_let_go_until_they_may_meet_again() {
        assertThat(ClosingGap.next(1, -1e-17, 5, 10, 1)).isEqualTo(2); // thrown up with 5 under 10: back after 1
        assertThat(ClosingGap.next(1, 1e-17, -5, 10, 1)).isEqualTo(1);
    }

    @Test
    void a_ball_thrown_past_a_corner_of_its_parabola_is_found_where_its_chord_misses() {
        // Both ends of the path are 1 above the wall at which the ball turns: y = 1 − 20 t (1 − t), radius 0.5.
        double t = FirstTouch.ofWall(0.5, 0.5, 40, 0, 1, 1);

        assertThat(0.5 - 20 * t * (1 - t)).isCloseTo(0, within(1e-14));
        assertThat(t).isLessThan(0.5);
        assertThat(TimeOfImpact.ofWall(0.5, 0.5, -20, 40, 0, 1)).isNaN();
    }

    @Test
    void no_touch_of_two_circles_is_missed_that_small_steps_find() {
        var rng = new Rng(4);
        int touches = 0;
        for (int n = 0; n < 2000; n++) {
            double d0x = rng.between(-3, 3);
            double d0y = rng.between(1, 3);
            double d1x = rng.between(-3, 3);
            double d1y = rng.between(-3, 3);
            double bx = rng.between(-30, 30);
            double by = rng.between(-30, 30);
            double t = FirstTouch.ofCircles(d0x, d0y, d1x, d1y, bx, by, 0, 1, 1);
            double until = Double.isNaN(t) ? 1 : t;
            for (int k = 1; k < 1000; k++) {
                double s = until * k / 1000;
                assertThat(distance(d0x, d0y, d1x, d1y, bx, by, s))
                        .as("case %d at %s", n, s)
                        .isGreaterThan(1 - 1e-12);
            }
            if (!Double.isNaN(t)) {
                touches++;
                assertThat(distance(d0x, d0y, d1x, d1y, bx, by, t))
                        .as("case %d", n)
                        .isCloseTo(1, within(1e-13));
            }
        }
        assertThat(touches).isGreaterThan(500);
    }

    private static double distance(double d0x, double d0y, double d1x, double d1y, double bx, double by, double s) {
        double bend = 0.5 * s * (1 - s);
        return Math.hypot(d0x + (d1x - d0x) * s - bx * bend, d0y + (d1y - d0y) * s - by * bend);
    }
}

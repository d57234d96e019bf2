package io.github.apsis.engine.math;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class PeriodTest {
    private final Period period = new Period(new Aabb(-5, -5, 5, 15));

    @Test
    void takes_the_nearest_image_of_a_distance() {
        assertThat(period.nearestX(9)).isEqualTo(-1);
        assertThat(period.nearestX(-9)).isEqualTo(1);
        assertThat(period.nearestY(9)).isEqualTo(9);
    }

    @Test
    void puts_every_point_inside_the_box() {
        assertThat(period.insideX(7)).isEqualTo(-3);
        assertThat(period.insideX(-5)).isEqualTo(-5);
        assertThat(period.insideX(5)).isEqualTo(-5);
        assertThat(period.insideX(Math.nextDown(-5.0))).isBetween(-5.0, Math.nextDown(5.0));
        assertThat(period.insideX(1234567)).isBetween(-5.0, Math.nextDown(5.0));
    }
}

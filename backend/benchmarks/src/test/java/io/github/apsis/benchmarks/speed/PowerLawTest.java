package io.github.apsis.benchmarks.speed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PowerLawTest {
    @ParameterizedTest
    @ValueSource(doubles = {0, 1, 1.15, 2})
    void a_cost_that_is_a_power_has_its_exponent(double k) {
        List<double[]> points = List.of(
                new double[] {1000, 3 * Math.pow(1000, k)},
                new double[] {5000, 3 * Math.pow(5000, k)},
                new double[] {100_000, 3 * Math.pow(100_000, k)});

        assertThat(PowerLaw.exponent(points)).hasValueCloseTo(k, within(1e-12)); // rounding of logarithms
    }

    @Test
    void what_a_tick_costs_with_few_bodies_does_not_count() {
        List<double[]> points =
                List.of(new double[] {10, 5}, new double[] {999, 5}, new double[] {1000, 1}, new double[] {10_000, 10});

        assertThat(PowerLaw.exponent(points)).hasValueCloseTo(1.0, within(1e-12));
    }

    @Test
    void one_size_has_no_exponent() {
        assertThat(PowerLaw.exponent(List.of())).isEmpty();
        assertThat(PowerLaw.exponent(List.of(new double[] {5000, 2}))).isEmpty();
    }
}

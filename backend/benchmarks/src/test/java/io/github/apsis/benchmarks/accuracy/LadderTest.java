package io.github.apsis.benchmarks.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.benchmarks.accuracy.Ladder.Thoroughness;
import io.github.apsis.benchmarks.reference.Fraction;
import java.io.IOException;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

class LadderTest {
    private static final Ladder FULL = new Ladder(List.of(Method.values()), null, null, Thoroughness.FULL);

    private static NBodyCase shipped(String id) throws IOException {
        return ReferenceFolder.shipped(id::equals).orbits().get(0);
    }

    @Test
    void every_fixed_method_runs_at_a_rooms_tick() throws IOException {
        List<Setting> settings = FULL.of(shipped("figure8"));

        for (Method method : Method.values()) {
            assertThat(settings).anyMatch(one -> one.method() == method && Math.abs(one.dt() * 150 - 1) < 1e-12);
        }
    }

    @Test
    void long_periods_get_long_steps() throws IOException {
        List<Double> steps = FULL.of(shipped("outer-solar")).stream()
                .filter(one -> one.method() == Method.LEAPFROG)
                .map(Setting::dt)
                .toList();

        assertThat(steps).contains(1 / 9.375, 1 / 18.75, 1 / 37.5, 1.0 / 75, 1.0 / 150, 1.0 / 300);
    }

    @Test
    void the_adaptive_method_runs_over_its_tolerances_and_once_as_in_a_room() throws IOException {
        List<Setting> settings = FULL.of(shipped("figure8")).stream()
                .filter(one -> one.method() == Method.ADAPTIVE)
                .toList();

        assertThat(settings)
                .extracting(Setting::tolerance)
                .containsExactly(1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16, 1e-16);
        assertThat(settings.subList(0, 12)).allMatch(one -> one.dt() == 1); // its samples are at 1, 3, 6, 63, 300, 633
    }

    @Test
    void a_step_that_misses_the_last_sample_is_fitted_to_it() throws IOException {
        NBodyCase kepler = shipped("kepler-e05-equal"); // 6283 times 37.5 is no whole number

        double dt = Ticks.fitting(1 / 37.5, kepler);

        assertThat(dt).isNotEqualTo(1 / 37.5).isCloseTo(1 / 37.5, within(1e-6));
        assertThat(Ticks.until(kepler.end(), dt)).isPositive();
    }

    @Test
    void samples_that_share_no_tick_get_one_to_the_end() throws IOException {
        NBodyCase figure8 = shipped("figure8");
        double[] none = new double[3];
        NBodyCase odd = new NBodyCase(
                "odd",
                1,
                0,
                figure8.bodies(),
                0,
                Arrays.asList(new Sample(1, none, none), new Sample(Math.PI, none, none)),
                1,
                1,
                1,
                1,
                1,
                figure8.file());

        assertThat(Ticks.longest(odd)).isEqualTo(Math.PI);
    }

    @Test
    void steps_read_and_write_as_people_write_them() {
        assertThat(Fraction.parse("1/150")).isEqualTo(1.0 / 150);
        assertThat(Fraction.format(1.0 / 150)).isEqualTo("1/150");
        assertThat(Fraction.format(1 / 37.5)).isEqualTo("1/37.5");
        assertThat(Fraction.format(1)).isEqualTo("1");
        assertThat(Fraction.format(100)).isEqualTo("100");
    }
}

package io.github.apsis.benchmarks.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.benchmarks.accuracy.OrbitErrors.AtSample;
import io.github.apsis.benchmarks.accuracy.Tolerances.Limit;
import java.util.List;
import org.junit.jupiter.api.Test;

class VerdictTest {
    private static final double ANY = Double.POSITIVE_INFINITY;
    private static final double NONE = Double.NaN;
    private static final OrbitErrors RUN = new OrbitErrors(
            List.of(new AtSample(6, 1e-5, NONE, 1e-14, 1e-4), new AtSample(63, 1e-5, NONE, 1e-14, 1.2e-3)), 0, false);

    private static Limit limit(double until, double energy, double position) {
        return new Limit("figure8", "leapfrog", 1.0 / 150, until, energy, ANY, position);
    }

    @Test
    void within_all_limits_is_ok() {
        assertThat(Verdict.of(RUN, List.of(limit(6, 1e-4, 2e-4), limit(63, 1e-4, 2e-3))))
                .isEqualTo("ok");
    }

    @Test
    void a_broken_limit_is_named_with_its_figures_and_moment() {
        assertThat(Verdict.of(RUN, List.of(limit(6, 1e-4, 2e-4), limit(63, 1e-4, 8e-4))))
                .isEqualTo("outside tolerance: position 1.2e-03 > 8.0e-04 at T=63");
        assertThat(Verdict.of(RUN, List.of(limit(6, 1e-6, 2e-4))))
                .isEqualTo("outside tolerance: energy 1.0e-05 > 1.0e-06 at T=6");
    }

    @Test
    void energy_is_judged_once_per_unit_of_time_as_its_limits_were_measured() {
        OrbitErrors swinging = new OrbitErrors(List.of(new AtSample(6, 5e-6, 2e-8, 0, 1e-4)), 0, false);
        List<Limit> limits = List.of(limit(6, 3e-8, 2e-4));

        assertThat(Verdict.of(swinging, limits)).isEqualTo("ok");
        assertThat(Verdict.swings(swinging, limits)).isTrue();
        assertThat(Verdict.of(swinging, List.of(limit(6, 1e-8, 2e-4)))).startsWith("outside tolerance: energy");
    }

    @Test
    void where_nothing_is_asked_a_run_that_loses_its_energy_cannot_follow() {
        OrbitErrors lost = new OrbitErrors(List.of(new AtSample(6, 30, NONE, 0, 700)), 0, false);

        assertThat(Verdict.of(lost, List.of(limit(6, ANY, ANY)))).isEqualTo("cannot follow");
        assertThat(Verdict.of(RUN, List.of())).isEqualTo("ok");
    }

    @Test
    void a_figure_that_is_no_number_has_failed() {
        OrbitErrors wrong = new OrbitErrors(List.of(new AtSample(6, NONE, NONE, 0, 1)), 0, false);

        assertThat(Verdict.of(wrong, List.of())).startsWith("failed: ");
        assertThat(Verdict.isBad("failed: x")).isTrue();
        assertThat(Verdict.isBad("cannot follow")).isFalse();
    }

    @Test
    void momentum_out_of_nowhere_has_failed() {
        OrbitErrors pushed = new OrbitErrors(RUN.samples(), 1e-3, false);

        assertThat(Verdict.of(pushed, List.of())).isEqualTo("failed: momentum changed by 1.0e-03");
    }
}

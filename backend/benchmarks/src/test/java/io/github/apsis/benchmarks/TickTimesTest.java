package io.github.apsis.benchmarks;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.math.Rng;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class TickTimesTest {
    private final TickTimes times = new TickTimes();

    @Test
    void without_ticks_everything_is_zero() {
        assertThat(times.count()).isZero();
        assertThat(times.percentileNanos(0.5)).isZero();
        assertThat(times.maxNanos()).isZero();
    }

    @Test
    void the_maximum_and_the_sum_are_exact() {
        times.record(1_000_003);
        times.record(17);

        assertThat(times.maxNanos()).isEqualTo(1_000_003);
        assertThat(times.totalNanos()).isEqualTo(1_000_020);
        assertThat(times.percentileNanos(1)).isEqualTo(1_000_003);
    }

    @Test
    void a_percentile_is_never_too_low_and_at_most_a_sixtieth_too_high() {
        Rng rng = new Rng(3);
        long[] all = new long[10_000];
        for (int i = 0; i < all.length; i++) {
            all[i] = (long) Math.exp(rng.between(0, 40)); // up to 10^17: every size of bucket
            times.record(all[i]);
        }
        Arrays.sort(all);

        for (double share : new double[] {0.001, 0.1, 0.5, 0.9, 0.99, 1}) {
            long exact = all[(int) Math.ceil(share * all.length) - 1];
            assertThat(times.percentileNanos(share)).isBetween(exact, exact + exact / 60 + 1);
        }
    }

    @Test
    void a_clock_that_steps_back_counts_as_no_time() {
        times.record(-5);

        assertThat(times.count()).isOne();
        assertThat(times.totalNanos()).isZero();
    }
}

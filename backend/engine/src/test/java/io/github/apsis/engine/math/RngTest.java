package io.github.apsis.engine.math;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class RngTest {
    @Test
    void gives_the_published_splitmix64_numbers() {
        var rng = new Rng(1);

        assertThat(rng.nextLong()).isEqualTo(0x910a2dec89025cc1L);
        assertThat(rng.nextLong()).isEqualTo(0xbeeb8da1658eec67L);
    }

    @Test
    void is_uniform_to_the_statistics_of_the_sample() {
        var rng = new Rng(7);
        double sum = 0;
        int n = 100_000;
        for (int i = 0; i < n; i++) {
            sum += rng.between(-1, 1);
        }

        // Five standard deviations of the mean of n numbers with variance 1/3.
        assertThat(sum / n).isCloseTo(0, within(5 * Math.sqrt(1.0 / 3 / n)));
    }

    @Test
    void by_counter_depends_on_each_argument_and_on_nothing_else() {
        assertThat(Rng.unitAt(1, 2, 3)).isEqualTo(Rng.unitAt(1, 2, 3));
        assertThat(Rng.unitAt(1, 2, 3)).isNotEqualTo(Rng.unitAt(2, 2, 3));
        assertThat(Rng.unitAt(1, 2, 3)).isNotEqualTo(Rng.unitAt(1, 3, 3));
        assertThat(Rng.unitAt(1, 2, 3)).isNotEqualTo(Rng.unitAt(1, 2, 4));
    }
}

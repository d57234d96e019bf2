package io.github.apsis.engine.math;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class CompensatedSumTest {
    @Test
    void keeps_what_plain_addition_loses() {
        var sum = new CompensatedSum();
        sum.add(1);
        sum.add(1e100);
        sum.add(1);
        sum.add(-1e100);

        assertThat(sum.value()).isEqualTo(2);
    }
}

package io.github.apsis.server.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class TickThreadTest {
    private final TickThread thread = new TickThread(new FakeTime(), () -> 0);

    @Test
    void rooms_that_fit_run_at_real_time() {
        thread.needs("a", 0.5);
        thread.needs("b", 0.4);

        assertThat(thread.load()).isCloseTo(0.9, within(1e-15));
        assertThat(thread.speed("a")).isEqualTo(1);
        assertThat(thread.speed("b")).isEqualTo(1);
    }

    /** 0.9 − 0.1 = 0.8 is left for the two, 0.4 for each. */
    @Test
    void a_light_room_does_not_pay_for_the_heavy_ones() {
        thread.needs("light", 0.1);
        thread.needs("heavy", 0.8);
        thread.needs("heavier", 4);

        assertThat(thread.speed("light")).isEqualTo(1);
        assertThat(thread.speed("heavy")).isCloseTo(0.5, within(1e-15));
        assertThat(thread.speed("heavier")).isCloseTo(0.1, within(1e-15));
    }

    @Test
    void who_is_gone_needs_nothing() {
        thread.needs("a", 0.8);
        thread.needs("b", 0.8);

        thread.forget("b");

        assertThat(thread.speed("a")).isEqualTo(1);
        assertThat(thread.load()).isEqualTo(0.8);
    }
}

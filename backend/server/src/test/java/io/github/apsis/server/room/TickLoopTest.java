package io.github.apsis.server.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class TickLoopTest {
    private final FakeTime time = new FakeTime();
    private final TickMeter meter = new TickMeter(time.getAsLong());
    private final List<Long> ticks = new ArrayList<>();
    private final List<Throwable> failures = new ArrayList<>();
    private Runnable work = () -> {};
    private long waited; // for another program: time by the clock and no CPU time
    private final TickThread thread = new TickThread(time, () -> time.getAsLong() - waited);
    private final ClockSpeed speed = new ClockSpeed(thread, "room", time.getAsLong());
    private final TickLoop loop = new TickLoop(time, time, meter, speed, this::tick, failures::add);

    private void tick() {
        ticks.add(time.getAsLong());
        work.run();
    }

    @BeforeEach
    void start() {
        loop.start();
    }

    @Test
    void an_hour_has_540000_ticks() {
        time.pass(3600 * FakeTime.SECOND);

        assertThat(ticks).hasSize(540_000 + 1); // the first one at once
        assertThat(meter.measure().ticksPerSecond()).isCloseTo(150, within(1e-6));
        assertThat(meter.measure().lateTicks()).isZero();
    }

    @Test
    void the_length_of_a_tick_does_not_shift_the_next() {
        work = () -> time.freeze(5_000_000);

        time.pass(10 * FakeTime.SECOND);

        assertThat(ticks).hasSize(1501);
        assertThat(meter.measure().p50Millis()).isEqualTo(5);
        assertThat(meter.measure().p99Millis()).isEqualTo(5);
    }

    @Test
    void missed_ticks_are_caught_up_at_once() {
        time.pass(FakeTime.SECOND);

        time.freeze(FakeTime.SECOND / 15); // ten ticks
        time.pass(FakeTime.SECOND);

        assertThat(ticks).hasSize(1 + 150 + 10 + 150);
        assertThat(meter.measure().droppedTicks()).isZero();
        assertThat(meter.measure().lateTicks()).isBetween(9L, 10L);
    }

    @Test
    void too_many_missed_ticks_are_dropped_and_counted() {
        time.pass(FakeTime.SECOND);

        time.freeze(10 * FakeTime.SECOND);
        time.pass(FakeTime.SECOND);

        long dropped = meter.measure().droppedTicks();
        assertThat(dropped).isBetween(1480L, 1490L);
        assertThat(ticks.size() + dropped).isEqualTo(1 + 12 * 150);
    }

    @Test
    void a_clock_that_a_thread_cannot_bear_runs_slower_and_drops_nothing_any_more() {
        work = () -> time.freeze(20_000_000); // 150 of them take three seconds
        time.pass(10 * FakeTime.SECOND);
        long droppedUntilItKnew = meter.measure().droppedTicks();
        int ticksBefore = ticks.size();

        time.pass(100 * FakeTime.SECOND);

        assertThat(meter.measure().speed()).isEqualTo(0.3); // 0.9 of the thread / 3
        assertThat(ticks.size() - ticksBefore).isBetween(4490, 4510); // 0.3 · 150 a second
        assertThat(meter.measure().droppedTicks()).isEqualTo(droppedUntilItKnew);
    }

    @Test
    void a_clock_is_right_again_when_the_work_has_become_lighter() {
        work = () -> time.freeze(20_000_000);
        time.pass(10 * FakeTime.SECOND);

        work = () -> time.freeze(1_000_000);
        time.pass(10 * FakeTime.SECOND);
        int ticksBefore = ticks.size();
        time.pass(10 * FakeTime.SECOND);

        assertThat(meter.measure().speed()).isEqualTo(1);
        assertThat(ticks.size() - ticksBefore).isBetween(1499, 1501);
    }

    @Test
    void a_thread_that_now_and_then_waits_for_other_programs_slows_no_clock() {
        work = () -> {
            time.freeze(1_000_000);
            if (ticks.size() % 300 == 0) {
                time.freeze(FakeTime.SECOND);
                waited += FakeTime.SECOND;
            }
        };

        time.pass(60 * FakeTime.SECOND);

        assertThat(meter.measure().speed()).isEqualTo(1);
        assertThat(meter.measure().droppedTicks()).isPositive();
    }

    @Test
    void a_machine_that_never_gives_enough_slows_the_clock_instead_of_dropping_for_ever() {
        work = () -> {
            time.freeze(20_000_000);
            waited += 19_000_000;
        };
        time.pass(20 * FakeTime.SECOND);
        long droppedUntilItKnew = meter.measure().droppedTicks();

        time.pass(60 * FakeTime.SECOND);

        assertThat(meter.measure().speed()).isEqualTo(0.3); // 0.9 of the thread / 3
        assertThat(meter.measure().droppedTicks()).isEqualTo(droppedUntilItKnew);
    }

    @Test
    void a_single_long_tick_slows_no_clock() {
        work = () -> time.freeze(1_000_000);
        time.pass(5 * FakeTime.SECOND);

        work = () -> {
            time.freeze(100_000_000); // a collection of garbage
            work = () -> time.freeze(1_000_000);
        };
        time.pass(FakeTime.SECOND);

        assertThat(meter.measure().speed()).isEqualTo(1);
        assertThat(meter.measure().droppedTicks()).isZero();
    }

    @Test
    void a_tick_that_throws_ends_the_loop() {
        work = () -> {
            throw new IllegalStateException("broken");
        };

        time.pass(FakeTime.SECOND);

        assertThat(ticks).hasSize(1);
        assertThat(failures).singleElement().isInstanceOf(IllegalStateException.class);
    }

    @Test
    void the_schedule_is_exact_after_ten_years() {
        TickSchedule schedule = new TickSchedule(0);
        long years = 10L * 365 * 86_400;

        long dropped = schedule.dropMissed(years * FakeTime.SECOND) + TickSchedule.MOST_MISSED;

        assertThat(dropped).isEqualTo(years * 150);
    }
}

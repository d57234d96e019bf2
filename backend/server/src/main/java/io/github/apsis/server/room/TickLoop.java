package io.github.apsis.server.room;

import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * Ticks one room at exactly 150 Hz in the mean. A tick that comes late is caught up at once; beyond
 * {@link TickSchedule#MOST_MISSED} missed ones time is dropped. Where the thread cannot bear 150 ticks a second, the clock
 * of the room runs slower, evenly, and says so: see {@link ClockSpeed}. dt never changes.
 *
 * <p>The executor must have one thread, on which everything here runs; it may carry many loops.
 */
final class TickLoop {
    static final int TICKS_PER_SECOND = 150;

    private final ScheduledExecutorService executor;
    private final LongSupplier nanoTime;
    private final Runnable tick;
    private final Consumer<Throwable> onFailure;
    private final TickMeter meter;
    private final TickSchedule schedule;
    private final ClockSpeed speed;
    private volatile boolean stopped;

    /** {@code onFailure} is called on the tick thread when a tick has thrown; the loop has ended by then. */
    TickLoop(
            ScheduledExecutorService executor,
            LongSupplier nanoTime,
            TickMeter meter,
            ClockSpeed speed,
            Runnable tick,
            Consumer<Throwable> onFailure) {
        this.executor = executor;
        this.nanoTime = nanoTime;
        this.meter = meter;
        this.speed = speed;
        this.tick = tick;
        this.onFailure = onFailure;
        this.schedule = new TickSchedule(nanoTime.getAsLong());
    }

    /** The first tick is due now, whenever the loop was made. */
    void start() {
        schedule.beginAt(nanoTime.getAsLong());
        scheduleNext();
    }

    /** No further tick begins. Any thread. */
    void stop() {
        stopped = true;
    }

    // One shot each time: a fixed period would have to be whole nanoseconds, and 10⁹ / 150 is not.
    private void scheduleNext() {
        try {
            long delay = Math.max(0, schedule.due() - nanoTime.getAsLong());
            executor.schedule(this::runAndScheduleNext, delay, TimeUnit.NANOSECONDS);
        } catch (RejectedExecutionException e) {
            stopped = true; // the server is going down
        }
    }

    private void runAndScheduleNext() {
        try {
            runDueTicks();
        } catch (RuntimeException
                | Error e) { // also out of memory, or a stack overflow: the room must not die silently
            stopped = true;
            onFailure.accept(e);
        }
        if (!stopped) {
            scheduleNext();
        }
    }

    /** Runs the ticks that are due by now. */
    void runDueTicks() {
        long dropped = schedule.dropMissed(nanoTime.getAsLong());
        meter.dropped(dropped);
        speed.dropped(dropped);
        for (int n = 0; n <= TickSchedule.MOST_MISSED && !stopped; n++) {
            long now = nanoTime.getAsLong();
            if (!schedule.isDue(now)) {
                return;
            }
            meter.began(now, schedule.due());
            schedule.advance();
            speed.began();
            tick.run();
            long end = nanoTime.getAsLong();
            meter.ended(end);
            speed.ended(end - now, end);
            schedule.runAt(speed.share());
            meter.runsAt(speed.share());
        }
    }
}

package io.github.apsis.server.room;

/**
 * How fast the clock of a room runs, as a share of real time: 1 as long as the thread bears it, less where the room is too heavy.
 *
 * <p>Twice a second the mean length of the ticks since then says what the room needs; half of the difference is believed, so a
 * single collection of garbage slows nobody. Whole percents, and changes of less than two are not made: a clock that wavers
 * is worse than one that is a percent slow.
 */
final class ClockSpeed {
    private static final long LOOK_EVERY_NANOS = 500_000_000;
    private static final double BELIEVED = 0.5;
    private static final double SLOWEST = 0.01;
    private static final double NOT_WORTH_IT = 0.02;

    private final TickThread thread;
    private final String room;
    private long lookedAt;
    private long busyNanos;
    private long ticks;
    private double speed = 1;

    /** Of a room on a thread, to begin with what the thread knows of it. */
    ClockSpeed(TickThread thread, String room, long now) {
        this.thread = thread;
        this.room = room;
        this.lookedAt = now;
    }

    /** Counts a tick that ended now. */
    void ticked(long nanos, long now) {
        busyNanos += nanos;
        ticks++;
        if (now - lookedAt >= LOOK_EVERY_NANOS) {
            look();
            lookedAt = now;
            busyNanos = 0;
            ticks = 0;
        }
    }

    private void look() {
        double measured = busyNanos * 1e-9 / ticks * TickLoop.TICKS_PER_SECOND;
        double believed = thread.load(room);
        thread.needs(room, believed + BELIEVED * (measured - believed));
        double possible = Math.max(SLOWEST, Math.floor(100 * thread.speed(room)) / 100);
        if (possible == 1 || Math.abs(possible - speed) >= NOT_WORTH_IT) {
            speed = possible;
        }
    }

    /** Above 0 and at most 1. */
    double share() {
        return speed;
    }
}

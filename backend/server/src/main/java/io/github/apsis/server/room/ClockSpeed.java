package io.github.apsis.server.room;

/**
 * How fast the clock of a room runs, as a share of real time: 1 as long as the thread bears it, less where the room is too heavy.
 *
 * <p>Twice a second the mean CPU time of the ticks since then says what the room needs; half of the difference is believed, so
 * a single heavy tick slows nobody. CPU time, because a tick that has to wait for another program is not heavy: that is
 * caught up or dropped. Only when ticks were dropped in two looks in a row has the machine so little to give that the
 * time by the clock counts, and then until that fits again.
 *
 * <p>Whole percents, and it gets faster by no less than two: a clock that wavers is worse than one that is a percent slow.
 */
final class ClockSpeed {
    private static final long LOOK_EVERY_NANOS = 500_000_000;
    private static final double BELIEVED = 0.5;
    private static final double SLOWEST = 0.01;
    private static final double NOT_WORTH_IT = 0.02;

    private final TickThread thread;
    private final String room;
    private long lookedAt;
    private long cpuBefore;
    private long cpuNanos;
    private long clockNanos;
    private long ticks;
    private boolean dropped;
    private boolean droppedBefore;
    private double speed = 1;

    /** Of a room on a thread, to begin with what the thread knows of it. */
    ClockSpeed(TickThread thread, String room, long now) {
        this.thread = thread;
        this.room = room;
        this.lookedAt = now;
    }

    /** A tick begins. */
    void began() {
        cpuBefore = thread.cpuNanos();
    }

    /** It ended now, after so long by the clock. */
    void ended(long nanos, long now) {
        cpuNanos += thread.cpuNanos() - cpuBefore;
        clockNanos += nanos;
        ticks++;
        if (now - lookedAt >= LOOK_EVERY_NANOS) {
            look();
            lookedAt = now;
            cpuNanos = 0;
            clockNanos = 0;
            ticks = 0;
            droppedBefore = dropped;
            dropped = false;
        }
    }

    /** Ticks were given up. */
    void dropped(long count) {
        dropped |= count > 0;
    }

    private void look() {
        boolean starved = speed < 1 || (dropped && droppedBefore);
        double measured = (starved ? clockNanos : cpuNanos) * 1e-9 / ticks * TickLoop.TICKS_PER_SECOND;
        double believed = thread.load(room);
        thread.needs(room, believed + BELIEVED * (measured - believed));
        double possible = Math.max(SLOWEST, Math.floor(100 * thread.speed(room)) / 100);
        if (possible < speed || possible == 1 || possible - speed >= NOT_WORTH_IT) {
            speed = possible;
        }
    }

    /** Above 0 and at most 1. */
    double share() {
        return speed;
    }
}

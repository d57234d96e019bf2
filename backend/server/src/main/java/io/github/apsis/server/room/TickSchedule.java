package io.github.apsis.server.room;

/**
 * When ticks are due: tick k at start + k · 1 s / 150, computed from k each time. A period of 6 666 666 ns added up
 * would gain a tick in 12 days, 6 ms would run at 166.7 Hz. A clock that runs slower than real time stretches the period.
 */
final class TickSchedule {
    /** A tenth of a second: more than any garbage collection, and caught up before anyone sees it. */
    static final int MOST_MISSED = 15;

    private static final long SECOND = 1_000_000_000L;

    private long start;
    private long next;
    private double speed = 1; // of real time

    TickSchedule(long start) {
        this.start = start;
    }

    /** The first tick is due now. */
    void beginAt(long now) {
        start = now;
        next = 0;
    }

    /** The clock runs at this share of real time from the next tick on, which stays due when it was. */
    void runAt(double share) {
        if (share != speed) {
            beginAt(due());
            speed = share;
        }
    }

    /** When the next tick is due. */
    long due() {
        // Whole seconds first: k · 10⁹ would overflow after two years.
        long seconds = next / TickLoop.TICKS_PER_SECOND;
        long rest = next % TickLoop.TICKS_PER_SECOND;
        long clock = seconds * SECOND + rest * SECOND / TickLoop.TICKS_PER_SECOND;
        return start + (speed == 1 ? clock : (long) (clock / speed));
    }

    boolean isDue(long now) {
        return now - due() >= 0;
    }

    void advance() {
        next++;
    }

    /** Gives up the ticks beyond those that may be caught up, and says how many. */
    long dropMissed(long now) {
        long late = Math.max(0, now - due());
        long behind = speed == 1 ? late : (long) (late * speed); // by the clock of the room
        long missed =
                behind / SECOND * TickLoop.TICKS_PER_SECOND + behind % SECOND * TickLoop.TICKS_PER_SECOND / SECOND;
        long tooMany = Math.max(0, missed - MOST_MISSED);
        next += tooMany;
        return tooMany;
    }
}

package io.github.apsis.server.room;

import java.util.Arrays;

/**
 * Measures the ticks of one room. Written by the tick thread alone; {@link #latest} and {@link #lastBegin} may be read
 * by any.
 */
final class TickMeter {
    private static final int WINDOW = 10 * TickLoop.TICKS_PER_SECOND;
    private static final long HALF_PERIOD_NANOS = 1_000_000_000L / TickLoop.TICKS_PER_SECOND / 2;

    private final long[] begins = new long[WINDOW];
    private final long[] durations = new long[WINDOW];
    private final long[] sorted = new long[WINDOW];
    private long count;
    private long late;
    private long dropped;
    private double speed = 1;
    private volatile long lastBegin;
    private volatile Pace latest = Pace.AT_START;

    TickMeter(long now) {
        lastBegin = now;
    }

    void began(long now, long due) {
        begins[(int) (count % WINDOW)] = now;
        lastBegin = now;
        if (now - due > HALF_PERIOD_NANOS) {
            late++;
        }
    }

    void ended(long now) {
        int i = (int) (count % WINDOW);
        durations[i] = now - begins[i];
        count++;
    }

    void dropped(long ticks) {
        dropped += ticks;
    }

    /** The clock runs at this share of real time. */
    void runsAt(double share) {
        speed = share;
    }

    /** Sums up the ticks so far: sorts 1500 numbers, so a few times a second will do. Tick thread. */
    Pace measure() {
        int n = (int) Math.min(count, WINDOW);
        System.arraycopy(durations, 0, sorted, 0, n);
        Arrays.sort(sorted, 0, n);
        latest = new Pace(rate(n), millisAt(0.50, n), millisAt(0.99, n), late, dropped, speed);
        return latest;
    }

    /** What was measured last. Any thread. */
    Pace latest() {
        return latest;
    }

    /** When the last tick began, by the clock of the loop. Any thread. */
    long lastBegin() {
        return lastBegin;
    }

    private double rate(int n) {
        int ticks = Math.min(n - 1, TickLoop.TICKS_PER_SECOND);
        if (ticks < 1) {
            return 0;
        }
        long newest = begins[(int) ((count - 1) % WINDOW)];
        long oldest = begins[(int) ((count - 1 - ticks) % WINDOW)];
        return newest == oldest ? 0 : ticks * 1e9 / (newest - oldest);
    }

    private double millisAt(double share, int n) {
        return n == 0 ? 0 : sorted[(int) Math.ceil(share * n) - 1] / 1e6;
    }
}

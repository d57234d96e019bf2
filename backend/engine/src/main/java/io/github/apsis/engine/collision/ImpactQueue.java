package io.github.apsis.engine.collision;

import java.util.Arrays;

/**
 * Predicted impacts, earliest first; equal times in the order of their bodies, so that the order never depends on how they
 * were found. A binary heap in columns.
 */
final class ImpactQueue {
    private int size;
    private double[] time = new double[16];
    private long[] pair = new long[16]; // first << 32 | second, walls moved up so that pairs are in order
    private long[] versions = new long[16]; // of the first << 32 | of the second

    void clear() {
        size = 0;
    }

    boolean isEmpty() {
        return size == 0;
    }

    void push(double t, int a, int b, int versionOfA, int versionOfB) {
        if (size == time.length) {
            time = Arrays.copyOf(time, 2 * size);
            pair = Arrays.copyOf(pair, 2 * size);
            versions = Arrays.copyOf(versions, 2 * size);
        }
        long pushed = (long) a << 32 | (long) b - Integer.MIN_VALUE;
        rise(size++, t, pushed, (long) versionOfA << 32 | versionOfB);
    }

    /**
     * Takes the earliest impact off; that stands at the head: {@link #time}, {@link #first} and the others read it. The gap it
     * leaves goes down to the end along the earlier children, for which nothing needs to be guessed, and what was last goes up from
     * there, by a step or none (Wegener 1993, Theor. Comput. Sci. 118, 81).
     */
    void pop() {
        size--;
        int gap = 0;
        while (2 * gap + 2 < size) {
            int child = earlier(2 * gap + 1);
            move(child, gap);
            gap = child;
        }
        if (2 * gap + 1 < size) {
            move(2 * gap + 1, gap);
            gap = 2 * gap + 1;
        }
        rise(gap, time[size], pair[size], versions[size]);
    }

    /** Of an entry and the next. */
    private int earlier(int k) {
        double later = time[k + 1] - time[k];
        if (later == 0) {
            return pair[k + 1] < pair[k] ? k + 1 : k;
        }
        return k + (int) (Double.doubleToRawLongBits(later) >>> 63); // 1 where negative, without a branch
    }

    /** Moves an entry up from a gap to where it belongs. */
    private void rise(int gap, double t, long bodies, long versionsOfBoth) {
        int k = gap;
        while (k > 0 && isBefore(t, bodies, (k - 1) / 2)) {
            move((k - 1) / 2, k);
            k = (k - 1) / 2;
        }
        set(k, t, bodies, versionsOfBoth);
    }

    double time() {
        return time[0];
    }

    int first() {
        return (int) (pair[0] >>> 32);
    }

    /** The other body, or a wall as a negative number. */
    int second() {
        return (int) pair[0] + Integer.MIN_VALUE;
    }

    int firstVersion() {
        return (int) (versions[0] >>> 32);
    }

    int secondVersion() {
        return (int) versions[0];
    }

    private boolean isBefore(double t, long bodies, int k) {
        return t < time[k] || t == time[k] && bodies < pair[k];
    }

    private void set(int k, double t, long bodies, long versionsOfBoth) {
        time[k] = t;
        pair[k] = bodies;
        versions[k] = versionsOfBoth;
    }

    private void move(int from, int to) {
        set(to, time[from], pair[from], versions[from]);
    }
}

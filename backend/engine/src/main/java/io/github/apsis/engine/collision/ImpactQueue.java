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
        int k = size++;
        while (k > 0 && isBefore(t, pushed, (k - 1) / 2)) {
            move((k - 1) / 2, k);
            k = (k - 1) / 2;
        }
        set(k, t, pushed, (long) versionOfA << 32 | versionOfB);
    }

    /** The earliest impact stands at the head: {@link #time}, {@link #first} and the others read it. */
    void pop() {
        size--;
        double t = time[size];
        long moved = pair[size];
        int k = 0;
        while (2 * k + 1 < size) {
            int child = 2 * k + 1;
            if (child + 1 < size && isBefore(time[child + 1], pair[child + 1], child)) {
                child++;
            }
            if (isBefore(t, moved, child)) {
                break;
            }
            move(child, k);
            k = child;
        }
        set(k, t, moved, versions[size]);
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

package io.github.apsis.engine.collision;

import java.util.Arrays;

/**
 * Predicted impacts, earliest first; equal times in the order of their bodies, so that the order never depends on how they
 * were found. A binary heap in columns.
 */
final class ImpactQueue {
    private int size;
    private double[] time = new double[16];
    private int[] first = new int[16];
    private int[] second = new int[16];
    private int[] firstVersion = new int[16];
    private int[] secondVersion = new int[16];

    void clear() {
        size = 0;
    }

    boolean isEmpty() {
        return size == 0;
    }

    void push(double t, int a, int b, int versionOfA, int versionOfB) {
        if (size == time.length) {
            time = Arrays.copyOf(time, 2 * size);
            first = Arrays.copyOf(first, 2 * size);
            second = Arrays.copyOf(second, 2 * size);
            firstVersion = Arrays.copyOf(firstVersion, 2 * size);
            secondVersion = Arrays.copyOf(secondVersion, 2 * size);
        }
        int k = size++;
        while (k > 0 && isBefore(t, a, b, (k - 1) / 2)) {
            move((k - 1) / 2, k);
            k = (k - 1) / 2;
        }
        set(k, t, a, b, versionOfA, versionOfB);
    }

    /** The earliest impact stands at the head: {@link #time}, {@link #first} and the others read it. */
    void pop() {
        size--;
        double t = time[size];
        int a = first[size];
        int b = second[size];
        int versionOfA = firstVersion[size];
        int versionOfB = secondVersion[size];
        int k = 0;
        while (2 * k + 1 < size) {
            int child = 2 * k + 1;
            if (child + 1 < size && isBefore(time[child + 1], first[child + 1], second[child + 1], child)) {
                child++;
            }
            if (isBefore(t, a, b, child)) {
                break;
            }
            move(child, k);
            k = child;
        }
        set(k, t, a, b, versionOfA, versionOfB);
    }

    double time() {
        return time[0];
    }

    int first() {
        return first[0];
    }

    /** The other body, or a wall as a negative number. */
    int second() {
        return second[0];
    }

    int firstVersion() {
        return firstVersion[0];
    }

    int secondVersion() {
        return secondVersion[0];
    }

    private boolean isBefore(double t, int a, int b, int k) {
        if (t != time[k]) {
            return t < time[k];
        }
        return a != first[k] ? a < first[k] : b < second[k];
    }

    private void set(int k, double t, int a, int b, int versionOfA, int versionOfB) {
        time[k] = t;
        first[k] = a;
        second[k] = b;
        firstVersion[k] = versionOfA;
        secondVersion[k] = versionOfB;
    }

    private void move(int from, int to) {
        set(to, time[from], first[from], second[from], firstVersion[from], secondVersion[from]);
    }
}

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
        set(k, t, a, b, versionOfA, versionOfB);
        while (k > 0 && before(k, (k - 1) / 2)) {
            swap(k, (k - 1) / 2);
            k = (k - 1) / 2;
        }
    }

    /** The earliest impact stands at the head: {@link #time}, {@link #first} and the others read it. */
    void pop() {
        size--;
        swap(0, size);
        int k = 0;
        while (2 * k + 1 < size) {
            int child = 2 * k + 1;
            if (child + 1 < size && before(child + 1, child)) {
                child++;
            }
            if (!before(child, k)) {
                return;
            }
            swap(k, child);
            k = child;
        }
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

    private boolean before(int k, int l) {
        if (time[k] != time[l]) {
            return time[k] < time[l];
        }
        return first[k] != first[l] ? first[k] < first[l] : second[k] < second[l];
    }

    private void set(int k, double t, int a, int b, int versionOfA, int versionOfB) {
        time[k] = t;
        first[k] = a;
        second[k] = b;
        firstVersion[k] = versionOfA;
        secondVersion[k] = versionOfB;
    }

    private void swap(int k, int l) {
        double t = time[k];
        int a = first[k];
        int b = second[k];
        int versionOfA = firstVersion[k];
        int versionOfB = secondVersion[k];
        set(k, time[l], first[l], second[l], firstVersion[l], secondVersion[l]);
        set(l, t, a, b, versionOfA, versionOfB);
    }
}

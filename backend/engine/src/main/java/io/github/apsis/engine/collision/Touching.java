package io.github.apsis.engine.collision;

import java.util.Arrays;

/**
 * The contacts of one tick that are too gentle to bounce: the partners, the normal and the gap with which the contact began,
 * and the impulse that each has passed on so far.
 */
final class Touching {
    private int size;
    private int[] first = new int[16];
    private int[] second = new int[16];
    private double[] normalX = new double[16];
    private double[] normalY = new double[16];
    private double[] firstGap = new double[16];
    private double[] impulse = new double[16];

    void clear() {
        size = 0;
    }

    /** Adds a contact between {@code a} and {@code b}, or a wall as a negative number, as it is at its beginning. */
    void add(int a, int b, ContactGeometry beginning) {
        if (size == first.length) {
            first = Arrays.copyOf(first, 2 * size);
            second = Arrays.copyOf(second, 2 * size);
            normalX = Arrays.copyOf(normalX, 2 * size);
            normalY = Arrays.copyOf(normalY, 2 * size);
            firstGap = Arrays.copyOf(firstGap, 2 * size);
            impulse = Arrays.copyOf(impulse, 2 * size);
        }
        first[size] = a;
        second[size] = b;
        normalX[size] = beginning.nx;
        normalY[size] = beginning.ny;
        firstGap[size] = beginning.gap;
        impulse[size] = 0;
        size++;
    }

    int size() {
        return size;
    }

    int first(int k) {
        return first[k];
    }

    /** The other body, or a wall as a negative number. */
    int second(int k) {
        return second[k];
    }

    double normalX(int k) {
        return normalX[k];
    }

    double normalY(int k) {
        return normalY[k];
    }

    /** The gap with which the contact began, length; negative where the partners overlapped already. */
    double firstGap(int k) {
        return firstGap[k];
    }

    double impulse(int k) {
        return impulse[k];
    }

    void setImpulse(int k, double value) {
        impulse[k] = value;
    }

    void clearImpulses() {
        Arrays.fill(impulse, 0, size, 0);
    }
}

package io.github.apsis.engine.collision;

import java.util.Arrays;

/** The contacts of one tick that are too gentle to bounce, with the impulse each has passed on so far. */
final class Touching {
    private int size;
    private int[] first = new int[16];
    private int[] second = new int[16];
    private double[] impulse = new double[16];

    void clear() {
        size = 0;
    }

    void add(int a, int b) {
        if (size == first.length) {
            first = Arrays.copyOf(first, 2 * size);
            second = Arrays.copyOf(second, 2 * size);
            impulse = Arrays.copyOf(impulse, 2 * size);
        }
        first[size] = a;
        second[size] = b;
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

    double impulse(int k) {
        return impulse[k];
    }

    void setImpulse(int k, double value) {
        impulse[k] = value;
    }
}

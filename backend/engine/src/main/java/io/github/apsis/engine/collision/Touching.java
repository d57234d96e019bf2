package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import java.util.Arrays;

/**
 * The contacts of one tick that are too gentle to bounce: the partners, the normal and the gap with which the contact began,
 * and the impulses that hold it. What held a pair in the last tick is the first guess for this one, so a pile needs to find
 * its impulses once and not in every tick.
 */
final class Touching {
    private int size;
    private PairIndex index = new PairIndex();
    private int[] first = new int[16];
    private int[] second = new int[16];
    private double[] normalX = new double[16];
    private double[] normalY = new double[16];
    private double[] firstGap = new double[16];
    private double[] holding = new double[16];
    private double[] settling = new double[16];
    private double[] parting = new double[16];

    // Of the last tick.
    private PairIndex indexBefore = new PairIndex();
    private double[] holdingBefore = new double[16];
    private double[] settlingBefore = new double[16];
    private double[] partingBefore = new double[16];
    private long removals = -1;
    private boolean[] supported = new boolean[16];

    /** Begins a new tick. */
    void begin(Bodies bodies) {
        if (bodies.count() > supported.length) {
            supported = new boolean[Math.max(bodies.count(), 2 * supported.length)];
        }
        Arrays.fill(supported, false);
        indexBefore.clear();
        if (bodies.removals() == removals) {
            keep();
        } else {
            removals = bodies.removals(); // slots mean other bodies now
            index.clear();
        }
        size = 0;
    }

    private void keep() {
        for (int k = 0; k < size; k++) {
            if (settling[k] > 0 || holding[k] > 0) {
                supported[first[k]] = true;
                if (second[k] >= 0) {
                    supported[second[k]] = true;
                }
            }
        }
        PairIndex emptied = indexBefore;
        indexBefore = index;
        index = emptied;
        double[] swap = holdingBefore;
        holdingBefore = holding;
        holding = swap;
        swap = settlingBefore;
        settlingBefore = settling;
        settling = swap;
        swap = partingBefore;
        partingBefore = parting;
        parting = swap;
        if (holding.length < first.length) {
            holding = new double[first.length];
            settling = new double[first.length];
            parting = new double[first.length];
        }
    }

    /** Whether a body has lain on something in the last tick: then it is pressed by others, and not in free fall. */
    boolean isSupported(int i) {
        return supported[i];
    }

    /** Adds a contact between {@code a} and {@code b}, or a wall as a negative number, as it is at its beginning; once. */
    void add(int a, int b, ContactGeometry beginning) {
        if (index.find(a, b) >= 0) {
            return;
        }
        if (size == first.length) {
            grow(2 * size);
        }
        int before = indexBefore.find(a, b);
        int k = size++;
        index.put(a, b, k);
        first[k] = a;
        second[k] = b;
        normalX[k] = beginning.nx;
        normalY[k] = beginning.ny;
        firstGap[k] = beginning.gap;
        holding[k] = before < 0 ? 0 : holdingBefore[before];
        settling[k] = before < 0 ? 0 : settlingBefore[before];
        parting[k] = before < 0 ? 0 : partingBefore[before];
    }

    private void grow(int capacity) {
        first = Arrays.copyOf(first, capacity);
        second = Arrays.copyOf(second, capacity);
        normalX = Arrays.copyOf(normalX, capacity);
        normalY = Arrays.copyOf(normalY, capacity);
        firstGap = Arrays.copyOf(firstGap, capacity);
        holding = Arrays.copyOf(holding, capacity);
        settling = Arrays.copyOf(settling, capacity);
        parting = Arrays.copyOf(parting, capacity);
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

    /** The impulse that holds a contact through the tick; before it is found, that of the last tick. */
    double holding(int k) {
        return holding[k];
    }

    void setHolding(int k, double impulse) {
        holding[k] = impulse;
    }

    /** The impulse that takes off what closes at the end of the tick; before it is found, that of the last tick. */
    double settling(int k) {
        return settling[k];
    }

    void setSettling(int k, double impulse) {
        settling[k] = impulse;
    }

    /** What parts an overlap, mass · length; before it is found, that of the last tick. */
    double parting(int k) {
        return parting[k];
    }

    void setParting(int k, double push) {
        parting[k] = push;
    }

    void clearParting() {
        Arrays.fill(parting, 0, size, 0);
    }
}

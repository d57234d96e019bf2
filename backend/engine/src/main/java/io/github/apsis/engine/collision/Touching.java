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

    // Of the last tick, and in first and second what has not been replaced yet.
    private int sizeBefore;
    private PairIndex indexBefore = new PairIndex();
    private double[] holdingBefore = new double[16];
    private double[] settlingBefore = new double[16];
    private double[] partingBefore = new double[16];
    private long removals = -1;
    private boolean isBorne; // whether anything was given support
    private int recalled; // contacts, one behind the other
    private int afterRecalled;
    private double[] support = new double[32]; // x, y of the speed that contacts gave each body in the last tick

    /** Begins a new tick. */
    void begin(Bodies bodies) {
        if (isBorne) {
            Arrays.fill(support, 0);
            isBorne = false;
        }
        indexBefore.clear();
        if (bodies.removals() == removals) {
            keep(bodies);
        } else {
            removals = bodies.removals(); // slots mean other bodies now
            index.clear();
            size = 0;
        }
        sizeBefore = size;
        size = 0;
        recalled = 0;
        afterRecalled = 0;
    }

    private void keep(Bodies bodies) {
        for (int k = 0; k < size; k++) {
            double impulse = holding[k] + settling[k];
            if (impulse > 0) {
                support(bodies, first[k], -impulse * normalX[k], -impulse * normalY[k]);
                support(bodies, second[k], impulse * normalX[k], impulse * normalY[k]);
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

    private void support(Bodies bodies, int i, double px, double py) {
        if (i >= 0) {
            isBorne = true;
            if (2 * bodies.count() > support.length) {
                support = Arrays.copyOf(support, Math.max(2 * bodies.count(), support.length + support.length / 8));
            }
            support[2 * i] += px * bodies.inverseMass(i);
            support[2 * i + 1] += py * bodies.inverseMass(i);
        }
    }

    /** The speed that contacts at rest gave to a body in the last tick: what it lies on bore so much of its fall. */
    double support(int i) {
        return isBorne ? Math.sqrt(supportSquared(i)) : 0;
    }

    double supportSquared(int i) {
        return i < 0 || !isBorne || 2 * i >= support.length
                ? 0
                : support[2 * i] * support[2 * i] + support[2 * i + 1] * support[2 * i + 1];
    }

    /** Adds a contact between {@code a} and {@code b}, or a wall as a negative number, as it is at its beginning; once. */
    void add(int a, int b, ContactGeometry beginning) {
        if (!index.put(a, b, size)) {
            return;
        }
        if (size == first.length) {
            resize(2 * size);
        }
        int k = size++;
        int before = k < sizeBefore && first[k] == a && second[k] == b
                ? k
                : indexBefore.find(a, b); // most are where they were
        first[k] = a;
        second[k] = b;
        normalX[k] = beginning.nx;
        normalY[k] = beginning.ny;
        firstGap[k] = beginning.gap;
        holding[k] = before < 0 ? 0 : holdingBefore[before];
        settling[k] = before < 0 ? 0 : settlingBefore[before];
        parting[k] = before < 0 ? 0 : partingBefore[before];
    }

    /** Adds a contact, whose impulses of a tick ago are those of an earlier one. */
    void recall(Bodies bodies, int a, int b, ContactGeometry beginning, double held, double settled) {
        int k = size;
        add(a, b, beginning);
        if (size == k) {
            return;
        }
        if (indexBefore.find(a, b) < 0) {
            holding[k] = held;
            settling[k] = settled;
            double impulse = held + settled;
            support(bodies, a, -impulse * normalX[k], -impulse * normalY[k]);
            support(bodies, b, impulse * normalX[k], impulse * normalY[k]);
        }
        recalled++;
        afterRecalled = size;
    }

    /** Whether a contact was recalled in this tick. */
    boolean isRecalled(int k) {
        return k < afterRecalled && k >= afterRecalled - recalled;
    }

    private void resize(int capacity) {
        first = Arrays.copyOf(first, capacity);
        second = Arrays.copyOf(second, capacity);
        normalX = Arrays.copyOf(normalX, capacity);
        normalY = Arrays.copyOf(normalY, capacity);
        firstGap = Arrays.copyOf(firstGap, capacity);
        holding = Arrays.copyOf(holding, capacity);
        settling = Arrays.copyOf(settling, capacity);
        parting = Arrays.copyOf(parting, capacity);
    }

    /** At the end of a tick: gives back the memory of contacts that are no more. */
    void shrink() {
        resize(Math.max(16, size));
        holdingBefore = new double[first.length];
        settlingBefore = new double[first.length];
        partingBefore = new double[first.length];
        indexBefore = new PairIndex();
        index = new PairIndex();
        for (int k = 0; k < size; k++) {
            index.put(first[k], second[k], k);
        }
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

    void turn(int k, double nx, double ny) {
        normalX[k] = nx;
        normalY[k] = ny;
    }

    /** The gap with which the contact began, length; negative where the partners overlapped already. */
    double firstGap(int k) {
        return firstGap[k];
    }

    /** Lets a contact have begun with no less than this gap. */
    void limitFirstOverlap(int k, double gap) {
        firstGap[k] = Math.max(gap, firstGap[k]);
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

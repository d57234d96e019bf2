package io.github.apsis.engine.body;

import java.util.Arrays;

/**
 * What positions have below their last bit: a list of the bodies for which that is not 0 while they are few, and a column when
 * they are many, or when an integrator carries it on for all.
 */
final class LowParts {
    private static final double[] NONE = new double[0];
    private static final int FEW = 16; // bodies to each in the list

    // By slot; nothing while there is a list.
    private double[] x = NONE;
    private double[] y = NONE;

    // The list, and the next one, which a drift writes: ascending.
    private int listed;
    private int[] slot = new int[8];
    private double[] listX = new double[8];
    private double[] listY = new double[8];
    private int next;
    private int[] nextSlot = new int[8];
    private double[] nextX = new double[8];
    private double[] nextY = new double[8];

    /** Whether they are known for every body. */
    boolean isColumn() {
        return x.length > 0;
    }

    /** Whether they are 0 for every body. */
    boolean isEmpty() {
        return !isColumn() && listed == 0;
    }

    /** Makes a column of them, for so many bodies. */
    void makeColumn(int capacity) {
        if (!isColumn()) {
            x = new double[capacity];
            y = new double[capacity];
            for (int k = 0; k < listed; k++) {
                x[slot[k]] = listX[k];
                y[slot[k]] = listY[k];
            }
            listed = 0;
        }
    }

    void grow(int capacity) {
        if (isColumn()) {
            x = Arrays.copyOf(x, capacity);
            y = Arrays.copyOf(y, capacity);
        }
    }

    double x(int i) {
        if (isColumn()) {
            return x[i];
        }
        int k = find(i);
        return k < 0 ? 0 : listX[k];
    }

    double y(int i) {
        if (isColumn()) {
            return y[i];
        }
        int k = find(i);
        return k < 0 ? 0 : listY[k];
    }

    private int find(int i) {
        return listed == 0 ? -1 : Arrays.binarySearch(slot, 0, listed, i);
    }

    /** Sets those of a body in the column. */
    void set(int i, double lowX, double lowY) {
        x[i] = lowX;
        y[i] = lowY;
    }

    /** Forgets those of a body. */
    void clear(int i) {
        if (isColumn()) {
            set(i, 0, 0);
            return;
        }
        int k = find(i);
        if (k >= 0) {
            drop(k);
        }
    }

    private void drop(int k) {
        int behind = --listed - k;
        System.arraycopy(slot, k + 1, slot, k, behind);
        System.arraycopy(listX, k + 1, listX, k, behind);
        System.arraycopy(listY, k + 1, listY, k, behind);
    }

    /** A body has been removed, and those behind it move up; so many are left. */
    void remove(int i, int count) {
        if (isColumn()) {
            System.arraycopy(x, i + 1, x, i, count - i);
            System.arraycopy(y, i + 1, y, i, count - i);
            return;
        }
        clear(i);
        for (int k = listed - 1; k >= 0 && slot[k] > i; k--) {
            slot[k]--;
        }
    }

    /** The slot at a place in the list, and one that no body has behind its end. */
    int slotAt(int k) {
        return k < listed ? slot[k] : Integer.MAX_VALUE;
    }

    double listedX(int k) {
        return listX[k];
    }

    double listedY(int k) {
        return listY[k];
    }

    /** Puts a body, in the order of slots, on the list that is next. */
    void note(int i, double lowX, double lowY) {
        if (next == nextSlot.length) {
            nextSlot = Arrays.copyOf(nextSlot, 2 * next);
            nextX = Arrays.copyOf(nextX, 2 * next);
            nextY = Arrays.copyOf(nextY, 2 * next);
        }
        nextSlot[next] = i;
        nextX[next] = lowX;
        nextY[next++] = lowY;
    }

    /** Takes the next list for this one, or makes a column of it where it is long. */
    void turn(int count, int capacity) {
        int[] turnedSlot = slot;
        slot = nextSlot;
        nextSlot = turnedSlot;
        double[] turned = listX;
        listX = nextX;
        nextX = turned;
        turned = listY;
        listY = nextY;
        nextY = turned;
        listed = next;
        next = 0;
        if (listed * FEW > count) {
            makeColumn(capacity);
        }
    }

    /** Folds those that are not 0 into a hash of so many bodies. */
    long hash(long from, int count) {
        long hash = from;
        for (int i = 0; i < count; i++) {
            hash = fold(hash, i, x(i));
        }
        for (int i = 0; i < count; i++) {
            hash = fold(hash, i, y(i));
        }
        return hash;
    }

    static long fold(long hash, int i, double low) {
        return low == 0 ? hash : StateHash.fold(StateHash.fold(hash, i), low); // most integrators carry none
    }
}

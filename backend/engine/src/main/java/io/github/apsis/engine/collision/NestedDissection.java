package io.github.apsis.engine.collision;

import java.util.Arrays;

/**
 * An order of bodies in which a matrix with an entry for every contact keeps most of its zeros when it is factored: one half of the
 * bodies, the other half, and last those of the one that touch the other; each half is ordered likewise (George 1973, SIAM J. Numer.
 * Anal. 10, 345). For n bodies in the plane the factor has about n log n entries.
 *
 * <p>What is not halved any more is a piece, and so are the bodies between two halves. A piece comes after those it parts.
 */
final class NestedDissection {
    /** So few bodies are not halved. */
    private static final int FEW = 6;

    private int[] order = new int[0];
    private int[] half = new int[0];
    private int[] between = new int[0];
    private int[] pieceStart = new int[1];
    private int[] parted = new int[0];
    private int pieces;

    private int marks;
    private double[] x = new double[0];
    private double[] y = new double[0];
    private int[] start = new int[0];
    private int[] neighbours = new int[0];

    /**
     * Orders bodies.
     *
     * @param start of the neighbours of each body, and the end of the last
     */
    void dissect(int bodies, double[] x, double[] y, int[] start, int[] neighbours) {
        this.x = x;
        this.y = y;
        this.start = start;
        this.neighbours = neighbours;
        if (bodies > order.length) {
            int capacity = Math.max(bodies, 2 * order.length);
            order = new int[capacity];
            half = new int[capacity];
            between = new int[capacity];
            pieceStart = new int[capacity + 1];
            parted = new int[capacity];
        }
        for (int i = 0; i < bodies; i++) {
            order[i] = i;
        }
        Arrays.fill(half, 0, bodies, 0);
        marks = 0;
        pieces = 0;
        if (bodies > 0) {
            dissect(0, bodies);
        }
        pieceStart[pieces] = bodies;
    }

    private void dissect(int from, int to) {
        if (to - from <= FEW) {
            parted[pieces] = from;
            pieceStart[pieces++] = from;
            return;
        }
        int middle = (from + to) >>> 1;
        select(from, to, middle, isWide(from, to) ? x : y);
        int near = ++marks;
        int far = ++marks;
        for (int p = from; p < to; p++) {
            half[order[p]] = p < middle ? near : far;
        }
        int apart = middle;
        int touching = 0;
        for (int p = middle; p < to; p++) {
            int i = order[p];
            if (touches(i, near)) {
                between[touching++] = i;
            } else {
                order[apart++] = i;
            }
        }
        System.arraycopy(between, 0, order, apart, touching);
        dissect(from, middle);
        if (apart > middle) {
            dissect(middle, apart);
        }
        if (touching > 0) {
            parted[pieces] = from;
            pieceStart[pieces++] = apart;
        }
    }

    private boolean isWide(int from, int to) {
        double left = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int p = from; p < to; p++) {
            left = Math.min(left, x[order[p]]);
            right = Math.max(right, x[order[p]]);
            low = Math.min(low, y[order[p]]);
            high = Math.max(high, y[order[p]]);
        }
        return right - left >= high - low;
    }

    private boolean touches(int i, int side) {
        for (int e = start[i]; e < start[i + 1]; e++) {
            if (half[neighbours[e]] == side) {
                return true;
            }
        }
        return false;
    }

    /** Brings the smaller keys before the middle and the larger behind it (Hoare 1961, Algorithm 65). */
    private void select(int from, int to, int middle, double[] key) {
        int low = from;
        int high = to - 1;
        while (low < high) {
            double pivot = key[order[(low + high) >>> 1]];
            int i = low;
            int j = high;
            while (i <= j) {
                while (key[order[i]] < pivot) {
                    i++;
                }
                while (key[order[j]] > pivot) {
                    j--;
                }
                if (i <= j) {
                    int swap = order[i];
                    order[i++] = order[j];
                    order[j--] = swap;
                }
            }
            if (middle <= j) {
                high = j;
            } else if (middle >= i) {
                low = i;
            } else {
                return;
            }
        }
    }

    /** The body at a place of the order. */
    int body(int place) {
        return order[place];
    }

    int pieces() {
        return pieces;
    }

    /** The place at which a piece starts; that of the piece after the last is the number of bodies. */
    int pieceStart(int piece) {
        return pieceStart[piece];
    }

    /** The place from which on the bodies are those that a piece parts, up to its own. */
    int parted(int piece) {
        return parted[piece];
    }
}

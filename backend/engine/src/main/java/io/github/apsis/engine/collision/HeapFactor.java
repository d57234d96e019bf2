package io.github.apsis.engine.collision;

import java.util.Arrays;

/**
 * The Cholesky factor L of the matrix of a heap,
 *
 * <pre>
 *   K = 1 + Σ_k weight_k · g_k g_kᵀ = L Lᵀ
 * </pre>
 *
 * <p>where g_k has entries only at the two bodies of contact k. Bodies are eliminated piece by piece of a {@link NestedDissection},
 * each in a small full matrix with the bodies that still border on it: the multifrontal method (Duff and Reid 1983, ACM Trans.
 * Math. Softw. 9, 302; Liu 1992, SIAM Review 34, 82).
 */
final class HeapFactor {
    private final NestedDissection dissection = new NestedDissection();
    private int bodies;
    private int contacts;
    private int[] first =
            new int[0]; // places of the bodies of contacts, in the order of elimination; −1 where there is none
    private int[] second = new int[0];
    private int[] place = new int[0];
    private int[] start = new int[0];
    private int[] neighbours = new int[0];

    // Of each piece: its contacts, the places that border on it when it is eliminated, and its columns of L.
    private int[] contactStart = new int[0];
    private int[] contactOf = new int[0];
    private int[] borderStart = new int[0];
    private int[] border = new int[0];
    private int[] children = new int[0]; // how many of the last pieces that wait are added to this one
    private int[] columnStart = new int[0];
    private double[] column = new double[0];

    private int[] pieceOf = new int[0];
    private int[] mark = new int[0];
    private int[] waiting = new int[0]; // pieces
    private int[] local = new int[0]; // the row of a place in the present front
    private int[] target = new int[0];
    private double[][] front =
            new double[0][0]; // by column: with arrays of their own C2 makes vector code of their loops
    private double[] left = new double[0]; // what pieces that wait have left for those that border on them
    private double[] work = new double[0];
    private double[] part = new double[0];

    /**
     * Finds where L has entries.
     *
     * @param first the bodies of contacts; negative where there is none
     */
    void analyse(int bodies, double[] x, double[] y, int contacts, int[] first, int[] second) {
        this.bodies = bodies;
        this.contacts = contacts;
        reserve();
        fillNeighbours(first, second);
        dissection.dissect(bodies, x, y, start, neighbours);
        int pieces = dissection.pieces();
        for (int p = 0; p < pieces; p++) {
            for (int q = dissection.pieceStart(p); q < dissection.pieceStart(p + 1); q++) {
                place[dissection.body(q)] = q;
                pieceOf[q] = p;
            }
        }
        sortContacts(first, second);
        fillBorders();
    }

    private void reserve() {
        if (bodies > place.length) {
            int capacity = Math.max(bodies, 2 * place.length);
            place = new int[capacity];
            start = new int[capacity + 2];
            contactStart = new int[capacity + 2];
            borderStart = new int[capacity + 1];
            children = new int[capacity];
            columnStart = new int[capacity + 1];
            pieceOf = new int[capacity];
            mark = new int[capacity];
            waiting = new int[capacity];
            local = new int[capacity];
            target = new int[2 * capacity];
            work = new double[2 * capacity];
            part = new double[2 * capacity];
        }
        if (contacts > first.length) {
            int capacity = Math.max(contacts, 2 * first.length);
            first = new int[capacity];
            second = new int[capacity];
            contactOf = new int[capacity];
            neighbours = new int[2 * capacity];
        }
    }

    private void fillNeighbours(int[] a, int[] b) {
        Arrays.fill(start, 0, bodies + 2, 0);
        for (int k = 0; k < contacts; k++) {
            if (a[k] >= 0 && b[k] >= 0) {
                start[a[k] + 2]++;
                start[b[k] + 2]++;
            }
        }
        for (int i = 2; i <= bodies + 1; i++) {
            start[i] += start[i - 1];
        }
        for (int k = 0; k < contacts; k++) {
            if (a[k] >= 0 && b[k] >= 0) {
                neighbours[start[a[k] + 1]++] = b[k];
                neighbours[start[b[k] + 1]++] = a[k];
            }
        }
    }

    /** A contact belongs to the piece in which its first body is eliminated. */
    private void sortContacts(int[] a, int[] b) {
        int pieces = dissection.pieces();
        Arrays.fill(contactStart, 0, pieces + 2, 0);
        for (int k = 0; k < contacts; k++) {
            first[k] = a[k] < 0 ? -1 : place[a[k]];
            second[k] = b[k] < 0 ? -1 : place[b[k]];
            if (Math.max(first[k], second[k]) >= 0) {
                contactStart[piece(k) + 2]++;
            }
        }
        for (int p = 2; p <= pieces + 1; p++) {
            contactStart[p] += contactStart[p - 1];
        }
        for (int k = 0; k < contacts; k++) {
            if (Math.max(first[k], second[k]) >= 0) {
                contactOf[contactStart[piece(k) + 1]++] = k;
            }
        }
    }

    private int piece(int k) {
        int earliest = Math.min(first[k], second[k]);
        return pieceOf[earliest < 0 ? Math.max(first[k], second[k]) : earliest];
    }

    private void fillBorders() {
        Arrays.fill(mark, 0, bodies, -1);
        int filled = 0;
        int entries = 0;
        int most = 0;
        int waits = 0;
        for (int p = 0; p < dissection.pieces(); p++) {
            int from = dissection.pieceStart(p);
            int to = dissection.pieceStart(p + 1);
            borderStart[p] = filled;
            columnStart[p] = entries;
            for (int q = from; q < to; q++) {
                int i = dissection.body(q);
                for (int e = start[i]; e < start[i + 1]; e++) {
                    filled = enter(place[neighbours[e]], p, to, filled);
                }
            }
            children[p] = 0;
            while (waits > 0 && dissection.pieceStart(waiting[waits - 1]) >= dissection.parted(p)) {
                int child = waiting[--waits];
                children[p]++;
                for (int e = borderStart[child]; e < borderStart[child + 1]; e++) {
                    filled = enter(border[e], p, to, filled);
                }
            }
            borderStart[p + 1] = filled;
            Arrays.sort(border, borderStart[p], filled);
            if (filled > borderStart[p]) {
                waiting[waits++] = p;
            }
            int rows = 2 * (to - from + filled - borderStart[p]);
            entries += rows * 2 * (to - from);
            most = Math.max(most, rows);
        }
        columnStart[dissection.pieces()] = entries;
        if (column.length < entries) {
            column = new double[entries + entries / 4];
        }
        if (front.length < most) {
            front = new double[most + most / 4][most + most / 4];
        }
    }

    private int enter(int q, int piece, int end, int filled) {
        if (q < end || mark[q] == piece) {
            return filled;
        }
        mark[q] = piece;
        if (filled == border.length) {
            border = Arrays.copyOf(border, Math.max(64, 2 * border.length));
        }
        border[filled] = q;
        return filled + 1;
    }

    /**
     * Computes L.
     *
     * @param ax the vectors g at the first bodies; they count where the weight is not 0
     */
    void factor(double[] ax, double[] ay, double[] bx, double[] by, double[] weight) {
        int held = 0;
        int waits = 0;
        for (int p = 0; p < dissection.pieces(); p++) {
            int from = dissection.pieceStart(p);
            int own = dissection.pieceStart(p + 1) - from;
            int rows = own + borderStart[p + 1] - borderStart[p];
            for (int q = 0; q < own; q++) {
                local[from + q] = 2 * q;
            }
            for (int e = borderStart[p]; e < borderStart[p + 1]; e++) {
                local[border[e]] = 2 * (own + e - borderStart[p]);
            }
            int n = 2 * rows;
            for (int c = 0; c < n; c++) {
                Arrays.fill(front[c], c, n, 0);
            }
            for (int j = 0; j < 2 * own; j++) {
                front[j][j] = 1;
            }
            for (int e = contactStart[p]; e < contactStart[p + 1]; e++) {
                int k = contactOf[e];
                if (weight[k] != 0) {
                    addContact(first[k], second[k], ax[k], ay[k], bx[k], by[k], weight[k]);
                }
            }
            for (int c = 0; c < children[p]; c++) {
                held = addChild(waiting[--waits], held);
            }
            eliminate(n, 2 * own);
            for (int j = 0; j < 2 * own; j++) {
                System.arraycopy(front[j], j, column, columnStart[p] + j * n + j, n - j);
            }
            if (rows > own) {
                held = hold(n, 2 * own, held);
                waiting[waits++] = p;
            }
        }
    }

    private void addContact(int a, int b, double ax, double ay, double bx, double by, double weight) {
        if (a >= 0) {
            addDiagonal(local[a], ax, ay, weight);
        }
        if (b >= 0) {
            addDiagonal(local[b], bx, by, weight);
        }
        if (a >= 0 && b >= 0) {
            if (a < b) {
                addBelow(local[a], local[b], ax, ay, bx, by, weight);
            } else {
                addBelow(local[b], local[a], bx, by, ax, ay, weight);
            }
        }
    }

    private void addDiagonal(int i, double gx, double gy, double weight) {
        front[i][i] += weight * gx * gx;
        front[i][i + 1] += weight * gx * gy;
        front[i + 1][i + 1] += weight * gy * gy;
    }

    private void addBelow(int c, int r, double cx, double cy, double rx, double ry, double weight) {
        front[c][r] += weight * cx * rx;
        front[c][r + 1] += weight * cx * ry;
        front[c + 1][r] += weight * cy * rx;
        front[c + 1][r + 1] += weight * cy * ry;
    }

    /** Adds what a piece has left, a triangle column by column at the end of what is held; returns how much is held without it. */
    private int addChild(int child, int held) {
        int count = borderStart[child + 1] - borderStart[child];
        for (int e = 0; e < count; e++) {
            target[2 * e] = local[border[borderStart[child] + e]];
            target[2 * e + 1] = target[2 * e] + 1;
        }
        int rows = 2 * count;
        int at = held - rows * (rows + 1) / 2;
        int before = at;
        for (int c = 0; c < rows; c++) {
            double[] to = front[target[c]];
            for (int r = c; r < rows; r++) {
                to[target[r]] += left[at++];
            }
        }
        return before;
    }

    /** Keeps what is left of the front below and right of the first columns. */
    private int hold(int n, int own, int held) {
        int rows = n - own;
        int needed = held + rows * (rows + 1) / 2;
        if (left.length < needed) {
            left = Arrays.copyOf(left, Math.max(needed, 2 * left.length));
        }
        int at = held;
        for (int c = own; c < n; c++) {
            System.arraycopy(front[c], c, left, at, n - c);
            at += n - c;
        }
        return at;
    }

    /** Cholesky's method on the first columns of the front, two bodies at a time: each pass over a front takes four columns off it. */
    private void eliminate(int n, int own) {
        int j = 0;
        for (; j < own - 2; j += 4) {
            double[] one = front[j];
            double[] two = front[j + 1];
            double[] three = front[j + 2];
            double[] four = front[j + 3];
            finish(j, n);
            subtract(three, one, two, one[j + 2], two[j + 2], j + 2, n);
            subtract(four, one, two, one[j + 3], two[j + 3], j + 3, n);
            finish(j + 2, n);
            for (int c = j + 4; c < n; c++) {
                subtract(front[c], one, two, three, four, one[c], two[c], three[c], four[c], c, n);
            }
        }
        if (j < own) {
            finish(j, n);
            for (int c = j + 2; c < n; c++) {
                subtract(front[c], front[j], front[j + 1], front[j][c], front[j + 1][c], c, n);
            }
        }
    }

    /** Makes columns of L of those of a body, from which all before have been taken off. */
    private void finish(int j, int n) {
        double[] one = front[j];
        double[] two = front[j + 1];
        double l00 = Math.sqrt(Math.max(1, one[j])); // K − 1 is not negative
        double l10 = one[j + 1] / l00;
        double l11 = Math.sqrt(Math.max(1, two[j + 1] - l10 * l10));
        one[j] = l00;
        one[j + 1] = l10;
        two[j + 1] = l11;
        divide(one, two, l10, 1 / l00, 1 / l11, j + 2, n);
    }

    private static void divide(double[] one, double[] two, double l10, double by0, double by1, int from, int to) {
        for (int r = from; r < to; r++) {
            double value = one[r] * by0;
            one[r] = value;
            two[r] = (two[r] - value * l10) * by1;
        }
    }

    /** Takes what two columns make of another column off it. */
    private static void subtract(double[] column, double[] one, double[] two, double a, double b, int from, int to) {
        for (int r = from; r < to; r++) {
            column[r] -= a * one[r] + b * two[r];
        }
    }

    /** The same of four. */
    private static void subtract(
            double[] column,
            double[] one,
            double[] two,
            double[] three,
            double[] four,
            double a,
            double b,
            double c,
            double d,
            int from,
            int to) {
        for (int r = from; r < to; r++) {
            column[r] -= a * one[r] + b * two[r] + (c * three[r] + d * four[r]);
        }
    }

    /** Solves K z = v in place; x, y of each body. */
    void solve(double[] v) {
        for (int q = 0; q < bodies; q++) {
            int i = 2 * dissection.body(q);
            work[2 * q] = v[i];
            work[2 * q + 1] = v[i + 1];
        }
        int pieces = dissection.pieces();
        for (int p = 0; p < pieces; p++) {
            forward(p);
        }
        for (int p = pieces - 1; p >= 0; p--) {
            back(p);
        }
        for (int q = 0; q < bodies; q++) {
            int i = 2 * dissection.body(q);
            v[i] = work[2 * q];
            v[i + 1] = work[2 * q + 1];
        }
    }

    private void forward(int p) {
        int from = dissection.pieceStart(p);
        int own = 2 * (dissection.pieceStart(p + 1) - from);
        int n = own + 2 * (borderStart[p + 1] - borderStart[p]);
        System.arraycopy(work, 2 * from, part, 0, own);
        Arrays.fill(part, own, n, 0);
        int one = columnStart[p];
        for (int j = 0; j < own; j += 2) {
            int two = one + n;
            double z0 = part[j] / column[one + j];
            double z1 = (part[j + 1] - column[one + j + 1] * z0) / column[two + j + 1];
            part[j] = z0;
            part[j + 1] = z1;
            for (int r = j + 2; r < n; r++) {
                part[r] -= column[one + r] * z0 + column[two + r] * z1;
            }
            one = two + n;
        }
        System.arraycopy(part, 0, work, 2 * from, own);
        for (int e = borderStart[p], r = own; r < n; e++, r += 2) {
            work[2 * border[e]] += part[r];
            work[2 * border[e] + 1] += part[r + 1];
        }
    }

    private void back(int p) {
        int from = dissection.pieceStart(p);
        int own = 2 * (dissection.pieceStart(p + 1) - from);
        int n = own + 2 * (borderStart[p + 1] - borderStart[p]);
        System.arraycopy(work, 2 * from, part, 0, own);
        for (int e = borderStart[p], r = own; r < n; e++, r += 2) {
            part[r] = work[2 * border[e]];
            part[r + 1] = work[2 * border[e] + 1];
        }
        for (int j = own - 2; j >= 0; j -= 2) {
            int one = columnStart[p] + j * n;
            int two = one + n;
            double sum0 = part[j];
            double sum1 = part[j + 1];
            for (int r = j + 2; r < n; r++) {
                sum0 -= column[one + r] * part[r];
                sum1 -= column[two + r] * part[r];
            }
            part[j + 1] = sum1 / column[two + j + 1];
            part[j] = (sum0 - column[one + j + 1] * part[j + 1]) / column[one + j];
        }
        System.arraycopy(part, 0, work, 2 * from, own);
    }
}

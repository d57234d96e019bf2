package io.github.apsis.engine.collision;

import java.util.Arrays;

/**
 * Pairs of bodies that are found in any order and read in that of their numbers, so what is computed from them has the same bits
 * however they were found.
 */
final class PairList {
    private static final int FEW = 32; // are sorted by insertion
    private static final int DIGIT = 11; // bits; a radix sort of many pairs counts them digit by digit
    private static final int MASK = (1 << DIGIT) - 1;

    private int bits = 1; // of a number
    private int size;
    private long[] pair = new long[16]; // first, second
    private long[] spare = new long[16];
    private int[] end = new int[0]; // by digit, once many have been sorted

    /** Forgets all pairs; the next are of so many bodies. */
    void clear(int count) {
        bits = Integer.SIZE - Integer.numberOfLeadingZeros(Math.max(1, count - 1));
        size = 0;
    }

    int size() {
        return size;
    }

    void add(int first, int second) {
        if (size == pair.length) {
            pair = Arrays.copyOf(pair, 2 * size);
            spare = new long[2 * size];
        }
        pair[size++] = (long) first << bits | second;
    }

    void sort() {
        if (size <= FEW) {
            sortFew();
        } else {
            if (end.length == 0) {
                end = new int[MASK + 1];
            }
            for (int shift = 0; shift < 2 * bits; shift += DIGIT) {
                sortByDigit(shift);
            }
        }
    }

    private void sortFew() {
        for (int k = 1; k < size; k++) {
            long moving = pair[k];
            int at = k;
            while (at > 0 && pair[at - 1] > moving) {
                pair[at] = pair[at - 1];
                at--;
            }
            pair[at] = moving;
        }
    }

    private void sortByDigit(int shift) {
        Arrays.fill(end, 0);
        for (int k = 0; k < size; k++) {
            end[(int) (pair[k] >>> shift) & MASK]++;
        }
        for (int digit = 1; digit <= MASK; digit++) {
            end[digit] += end[digit - 1];
        }
        for (int k = size - 1; k >= 0; k--) {
            spare[--end[(int) (pair[k] >>> shift) & MASK]] = pair[k];
        }
        long[] sorted = spare;
        spare = pair;
        pair = sorted;
    }

    int first(int k) {
        return (int) (pair[k] >>> bits);
    }

    int second(int k) {
        return (int) pair[k] & (1 << bits) - 1;
    }
}

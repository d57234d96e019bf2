package io.github.apsis.engine.collision;

import java.util.Arrays;

/** Where a contact stands in its list, by its partners: a hash table with open addressing. */
final class PairIndex {
    private static final long MIX =
            0x9e3779b97f4a7c15L; // 2^64 / golden ratio: Fibonacci hashing (Knuth 1973, TAOCP 3, 6.4)

    private int size;
    private long[] key = new long[64];
    private int[] place = new int[64]; // position + 1, 0 where the table is empty

    void clear() {
        if (size > 0) {
            Arrays.fill(place, 0);
            size = 0;
        }
    }

    /** The position of a pair, or −1. */
    int find(int first, int second) {
        return size == 0 ? -1 : place[at(pair(first, second))] - 1;
    }

    /** Notes the position of a pair, unless it has one; returns whether that is so. */
    boolean put(int first, int second, int position) {
        if (2 * size >= place.length) {
            grow();
        }
        long pair = pair(first, second);
        int at = at(pair);
        if (place[at] != 0) {
            return false;
        }
        key[at] = pair;
        place[at] = position + 1;
        size++;
        return true;
    }

    private int at(long pair) {
        int mask = place.length - 1;
        int at = (int) (pair * MIX >>> 32) & mask;
        while (place[at] != 0 && key[at] != pair) {
            at = at + 1 & mask;
        }
        return at;
    }

    private void grow() {
        long[] oldKey = key;
        int[] oldPlace = place;
        key = new long[2 * oldKey.length];
        place = new int[2 * oldKey.length];
        for (int i = 0; i < oldKey.length; i++) {
            if (oldPlace[i] != 0) {
                int at = at(oldKey[i]);
                key[at] = oldKey[i];
                place[at] = oldPlace[i];
            }
        }
    }

    private static long pair(int first, int second) {
        return (long) first << 32 | second & 0xffffffffL;
    }
}

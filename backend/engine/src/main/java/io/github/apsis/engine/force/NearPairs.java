package io.github.apsis.engine.force;

import java.util.Arrays;

/**
 * Pairs of leaves that must pull each other body by body, listed leaf by leaf: {@link #begin}, {@link #add} every pair once,
 * {@link #sort}, then read. A counting sort, so the order is that of the walk; nothing is allocated once warm.
 */
final class NearPairs {
    private int count;
    private int[] one = new int[64];
    private int[] other = new int[64];
    private int[] last = new int[64]; // by leaf, shifted by one: where its list begins, and later where it ends
    private int[] neighbour = new int[128];

    void begin() {
        count = 0;
    }

    void add(int leaf, int otherLeaf) {
        if (count == one.length) {
            one = Arrays.copyOf(one, 2 * count);
            other = Arrays.copyOf(other, 2 * count);
        }
        one[count] = leaf;
        other[count++] = otherLeaf;
    }

    /** Makes the lists, for leaves numbered below this. */
    void sort(int leaves) {
        if (last.length < leaves + 2) {
            last = new int[2 * leaves + 2];
        }
        if (neighbour.length < 2 * count) {
            neighbour = new int[2 * one.length];
        }
        Arrays.fill(last, 0, leaves + 2, 0);
        for (int k = 0; k < count; k++) {
            last[one[k] + 2]++;
            last[other[k] + 2]++;
        }
        for (int leaf = 2; leaf < leaves + 2; leaf++) {
            last[leaf] += last[leaf - 1];
        }
        for (int k = 0; k < count; k++) {
            neighbour[last[one[k] + 1]++] = other[k];
            neighbour[last[other[k] + 1]++] = one[k];
        }
    }

    /** Where the neighbours of a leaf begin in the order of {@link #neighbour}. */
    int first(int leaf) {
        return last[leaf];
    }

    /** Where they end. */
    int end(int leaf) {
        return last[leaf + 1];
    }

    int neighbour(int k) {
        return neighbour[k];
    }
}

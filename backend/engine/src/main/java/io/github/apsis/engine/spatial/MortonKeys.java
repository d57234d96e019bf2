package io.github.apsis.engine.spatial;

import java.util.Arrays;

/**
 * The places of a share of all items on a Z-order curve (Morton 1966): the box of their centres, then a key for each, of 32 bits
 * whose lower ones are 0, and how often each of its two digits occurs in them. Shares of one order do not depend on each other.
 */
final class MortonKeys {
    private static final double SCALE = 65535; // 16 bits along each axis

    double lowX;
    double lowY;
    double highX;
    double highY;
    int[] histogram = new int[0]; // of the lower digit of a key, and of the higher behind it

    /** Finds the box around the centres of a run. */
    void findBox(Quadtree tree, int start, int stop) {
        double left = Double.POSITIVE_INFINITY;
        double bottom = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        double top = Double.NEGATIVE_INFINITY;
        for (int p = start; p < stop; p++) {
            int i = tree.item(p);
            double x = tree.centreX(i);
            double y = tree.centreY(i);
            left = x < left ? x : left; // seldom; Math.min would wait for the one before
            bottom = y < bottom ? y : bottom;
            right = x > right ? x : right;
            top = y > top ? y : top;
        }
        lowX = left;
        lowY = bottom;
        highX = right;
        highY = top;
    }

    /** Widens the box by that of another share. */
    void join(MortonKeys other) {
        lowX = Math.min(lowX, other.lowX);
        lowY = Math.min(lowY, other.lowY);
        highX = Math.max(highX, other.highX);
        highY = Math.max(highY, other.highY);
    }

    /** Keys for each length; 0 or infinite where all centres are one, or are not to be told apart. */
    double scale() {
        double side = Math.max(highX - lowX, highY - lowY);
        double scale = SCALE / side;
        return scale > 0 ? scale : 0; // side is beyond the numbers
    }

    /** Gives keys of two digits to the items of a run, in the box of all, and counts these digits, which have so many bits. */
    void giveKeys(Quadtree tree, MortonKeys all, int start, int stop, int bits) {
        if (histogram.length < 2 << bits) {
            histogram = new int[2 << bits];
        } else {
            Arrays.fill(histogram, 0, 2 << bits, 0);
        }
        double scale = all.scale();
        double left = all.lowX;
        double bottom = all.lowY;
        int[] keys = tree.key;
        int[] count = histogram;
        int values = 1 << bits;
        int shift = 32 - 2 * bits;
        for (int p = start; p < stop; p++) {
            int i = tree.item(p);
            int column = (int) ((tree.centreX(i) - left) * scale);
            int row = (int) ((tree.centreY(i) - bottom) * scale);
            int key = (spread(column) | spread(row) << 1) >>> shift;
            keys[p] = key << shift;
            count[key & values - 1]++;
            count[values + (key >>> bits)]++;
        }
    }

    /** Adds what another share has counted. */
    void add(MortonKeys other, int bits) {
        int[] sum = histogram;
        int[] added = other.histogram;
        for (int value = 0; value < 2 << bits; value++) {
            sum[value] += added[value];
        }
    }

    /** Puts a zero between every two of 16 bits. */
    private static int spread(int bits) {
        int b = bits & 0xffff;
        b = (b | b << 8) & 0x00ff00ff;
        b = (b | b << 4) & 0x0f0f0f0f;
        b = (b | b << 2) & 0x33333333;
        return (b | b << 1) & 0x55555555;
    }
}

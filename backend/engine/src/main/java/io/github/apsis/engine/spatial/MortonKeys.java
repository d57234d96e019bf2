package io.github.apsis.engine.spatial;

import java.util.Arrays;

/**
 * The places of a share of all items on a Z-order curve (Morton 1966): the box of their centres, then a key of 32 bits for each,
 * and how often each digit occurs in them. Shares of one order do not depend on each other.
 */
final class MortonKeys {
    private static final double SCALE = 65535; // 16 bits along each axis

    double lowX;
    double lowY;
    double highX;
    double highY;
    int[] histogram = new int[0]; // of all digits of a key, one behind the other

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

    /** Gives keys to the items of a run, in the box of all, and counts their digits of so many bits. */
    void giveKeys(Quadtree tree, MortonKeys all, int start, int stop, int bits, int digits) {
        if (histogram.length < digits << bits) {
            histogram = new int[digits << bits];
        } else {
            Arrays.fill(histogram, 0, digits << bits, 0);
        }
        double scale = all.scale();
        double left = all.lowX;
        double bottom = all.lowY;
        int[] keys = tree.key;
        int[] count = histogram;
        int mask = (1 << bits) - 1;
        for (int p = start; p < stop; p++) {
            int i = tree.item(p);
            int column = (int) ((tree.centreX(i) - left) * scale);
            int row = (int) ((tree.centreY(i) - bottom) * scale);
            int key = spread(column) | spread(row) << 1;
            keys[p] = key;
            count[key & mask]++;
            count[(1 << bits) + (key >>> bits & mask)]++;
            count[(2 << bits) + (key >>> 2 * bits & mask)]++;
            if (digits > 3) {
                count[(3 << bits) + (key >>> 3 * bits)]++;
            }
        }
    }

    /** Adds what another share has counted. */
    void add(MortonKeys other, int values) {
        int[] sum = histogram;
        int[] added = other.histogram;
        for (int value = 0; value < values; value++) {
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

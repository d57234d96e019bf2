package io.github.apsis.engine.spatial;

import java.util.Arrays;

/**
 * Boxes in a quadtree, rebuilt from scratch each time: {@link #begin}, {@link #set} for every item, {@link #build}, then
 * {@link #query}.
 *
 * <p>Items are sorted along the Z-order curve of their centres (Morton 1966) by a radix sort; a node is a run of that order,
 * with the tight box around its items, so items of any size find their place. Nodes stand in preorder with a link past their
 * subtree: a query is one loop without a stack. Linear to build, and nothing is allocated once warm.
 */
public final class Quadtree {
    private static final int LEAF_SIZE = 8;
    private static final int LEVELS = 16; // two bits of the 32-bit Z-order key each
    private static final double KEY_SCALE = 65535;

    private int count;
    private double[] minX = new double[16];
    private double[] minY = new double[16];
    private double[] maxX = new double[16];
    private double[] maxY = new double[16];

    private long[] order = new long[16]; // key << 32 | item, sorted
    private long[] spare = new long[16];
    private final int[] histogram = new int[257];

    private int nodes;
    private double[] nodeMinX = new double[16];
    private double[] nodeMinY = new double[16];
    private double[] nodeMaxX = new double[16];
    private double[] nodeMaxY = new double[16];
    private int[] past = new int[16]; // the node behind the subtree
    private int[] from = new int[16]; // first item of a leaf, −1 for an inner node
    private int[] to = new int[16];

    private int[] found = new int[16];

    /** Forgets everything and makes room for this many items. */
    public void begin(int items) {
        count = items;
        nodes = 0;
        if (items > minX.length) {
            int capacity = Math.max(items, 2 * minX.length);
            minX = new double[capacity];
            minY = new double[capacity];
            maxX = new double[capacity];
            maxY = new double[capacity];
            order = new long[capacity];
            spare = new long[capacity];
        }
    }

    /** The box of one item; all numbers finite. */
    public void set(int item, double boxMinX, double boxMinY, double boxMaxX, double boxMaxY) {
        minX[item] = boxMinX;
        minY[item] = boxMinY;
        maxX[item] = boxMaxX;
        maxY[item] = boxMaxY;
    }

    /** Sorts the items and builds the nodes. */
    public void build() {
        if (count == 0) {
            return;
        }
        computeKeys();
        sortByKey();
        addNode(0, count, 0);
    }

    private void computeKeys() {
        double lowX = Double.POSITIVE_INFINITY;
        double lowY = Double.POSITIVE_INFINITY;
        double highX = Double.NEGATIVE_INFINITY;
        double highY = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            double x = 0.5 * minX[i] + 0.5 * maxX[i];
            double y = 0.5 * minY[i] + 0.5 * maxY[i];
            lowX = Math.min(lowX, x);
            lowY = Math.min(lowY, y);
            highX = Math.max(highX, x);
            highY = Math.max(highY, y);
        }
        double side = Math.max(highX - lowX, highY - lowY);
        double scale = side > 0 ? KEY_SCALE / side : 0;
        for (int i = 0; i < count; i++) {
            int column = (int) ((0.5 * minX[i] + 0.5 * maxX[i] - lowX) * scale);
            int row = (int) ((0.5 * minY[i] + 0.5 * maxY[i] - lowY) * scale);
            order[i] = (spread(column) | spread(row) << 1) << 32 | i;
        }
    }

    /** Puts a zero between every two of 16 bits. */
    private static long spread(int bits) {
        long b = bits & 0xffffL;
        b = (b | b << 8) & 0x00ff00ffL;
        b = (b | b << 4) & 0x0f0f0f0fL;
        b = (b | b << 2) & 0x33333333L;
        return (b | b << 1) & 0x55555555L;
    }

    /** Radix sort, four passes of eight bits; stable, so equal keys stay in item order. */
    private void sortByKey() {
        for (int shift = 32; shift < 64; shift += 8) {
            Arrays.fill(histogram, 0);
            for (int i = 0; i < count; i++) {
                histogram[(int) (order[i] >>> shift & 0xff) + 1]++;
            }
            for (int digit = 0; digit < 256; digit++) {
                histogram[digit + 1] += histogram[digit];
            }
            for (int i = 0; i < count; i++) {
                spare[histogram[(int) (order[i] >>> shift & 0xff)]++] = order[i];
            }
            long[] sorted = spare;
            spare = order;
            order = sorted;
        }
    }

    /** Adds the node of a run of the order, and everything below it. */
    private void addNode(int first, int end, int level) {
        int node = nodes++;
        if (node == past.length) {
            growNodes(2 * node);
        }
        int depth = level;
        while (end - first > LEAF_SIZE && depth < LEVELS && digit(first, depth) == digit(end - 1, depth)) {
            depth++; // all in one quarter: no chain of single children
        }
        if (end - first <= LEAF_SIZE || depth == LEVELS) {
            from[node] = first;
            to[node] = end;
            boxOfItems(node, first, end);
        } else {
            from[node] = -1;
            addChildren(node, first, end, depth);
        }
        past[node] = nodes;
    }

    private void addChildren(int node, int first, int end, int depth) {
        double lowX = Double.POSITIVE_INFINITY;
        double lowY = Double.POSITIVE_INFINITY;
        double highX = Double.NEGATIVE_INFINITY;
        double highY = Double.NEGATIVE_INFINITY;
        int begin = first;
        while (begin < end) {
            int stop = begin + 1;
            while (stop < end && digit(stop, depth) == digit(begin, depth)) {
                stop++;
            }
            int child = nodes;
            addNode(begin, stop, depth + 1);
            lowX = Math.min(lowX, nodeMinX[child]);
            lowY = Math.min(lowY, nodeMinY[child]);
            highX = Math.max(highX, nodeMaxX[child]);
            highY = Math.max(highY, nodeMaxY[child]);
            begin = stop;
        }
        setBox(node, lowX, lowY, highX, highY);
    }

    private int digit(int position, int depth) {
        return (int) (order[position] >>> (62 - 2 * depth)) & 3;
    }

    private int item(int position) {
        return (int) order[position];
    }

    private void boxOfItems(int node, int first, int end) {
        double lowX = Double.POSITIVE_INFINITY;
        double lowY = Double.POSITIVE_INFINITY;
        double highX = Double.NEGATIVE_INFINITY;
        double highY = Double.NEGATIVE_INFINITY;
        for (int p = first; p < end; p++) {
            int i = item(p);
            lowX = Math.min(lowX, minX[i]);
            lowY = Math.min(lowY, minY[i]);
            highX = Math.max(highX, maxX[i]);
            highY = Math.max(highY, maxY[i]);
        }
        setBox(node, lowX, lowY, highX, highY);
    }

    private void setBox(int node, double lowX, double lowY, double highX, double highY) {
        nodeMinX[node] = lowX;
        nodeMinY[node] = lowY;
        nodeMaxX[node] = highX;
        nodeMaxY[node] = highY;
    }

    private void growNodes(int capacity) {
        nodeMinX = Arrays.copyOf(nodeMinX, capacity);
        nodeMinY = Arrays.copyOf(nodeMinY, capacity);
        nodeMaxX = Arrays.copyOf(nodeMaxX, capacity);
        nodeMaxY = Arrays.copyOf(nodeMaxY, capacity);
        past = Arrays.copyOf(past, capacity);
        from = Arrays.copyOf(from, capacity);
        to = Arrays.copyOf(to, capacity);
    }

    /**
     * Finds the items whose boxes touch this one, rims included, in a fixed order; {@link #found} gives them, until the next
     * query.
     *
     * @return how many
     */
    public int query(double boxMinX, double boxMinY, double boxMaxX, double boxMaxY) {
        int hits = 0;
        int node = 0;
        while (node < nodes) {
            if (nodeMinX[node] > boxMaxX
                    || nodeMaxX[node] < boxMinX
                    || nodeMinY[node] > boxMaxY
                    || nodeMaxY[node] < boxMinY) {
                node = past[node];
                continue;
            }
            for (int p = from[node]; p >= 0 && p < to[node]; p++) {
                int i = item(p);
                if (minX[i] <= boxMaxX && maxX[i] >= boxMinX && minY[i] <= boxMaxY && maxY[i] >= boxMinY) {
                    if (hits == found.length) {
                        found = Arrays.copyOf(found, 2 * hits);
                    }
                    found[hits++] = i;
                }
            }
            node++;
        }
        return hits;
    }

    /** The {@code hit}-th item of the last query. */
    public int found(int hit) {
        return found[hit];
    }
}

package io.github.apsis.engine.spatial;

import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.parallel.Work;
import java.util.Arrays;

/**
 * Boxes in a quadtree, rebuilt from scratch each time: {@link #begin}, {@link #set} for every item, {@link #build}, then
 * {@link #query}.
 *
 * <p>Items are sorted along the Z-order curve of their centres (Morton 1966) by a radix sort; a node is a run of that order,
 * with the tight box around its items, so items of any size find their place. Nodes stand in preorder with a link past their
 * subtree: a query is one loop without a stack, and the children of {@code node} are {@code node + 1}, {@code past(node + 1)}
 * and so on, as long as they are below {@code past(node)}. Linear to build, and nothing is allocated once warm.
 *
 * <p>A key has 8 levels, or 11 where many are sorted: two digits of the radix sort. A run that is still too long there, such as
 * a cluster seen from a body that has flown off, gets keys anew within its own box; so depth follows the digits of a double and no
 * outlier turns a query into a look at all. Keys of 16 levels would be sorted in twice the time, for leaves that need half of them.
 */
public final class Quadtree {
    private static final int DEFAULT_LEAF_SIZE = 8;
    private static final int LEVELS = 16; // two bits of the 32-bit Z-order key each; the lower ones are 0

    // Digits of the radix sort, in bits: there are two, and a key has as many levels.
    private static final int NARROW = 8;
    private static final int WIDE = 11;
    private static final int MANY = 16_384; // with fewer, wide histograms are a hundredth of all memory or more
    private static final int MOST_SHARES = 8;
    private static final int MANY_FOR_A_TEAM = 4000; // items, whose keys take 30 µs: fewer are not shared

    private final Workspace workspace;
    private final int leafSize;
    private final boolean hasBoxes; // of its nodes
    private int count;
    private double[] minX = new double[0];
    private double[] minY = new double[0];
    private double[] maxX = new double[0];
    private double[] maxY = new double[0];

    int[] key = new int[0]; // sorted, as unsigned numbers
    int[] item = new int[0]; // of each key
    private int[] spareKey = new int[0];
    private int[] spareItem = new int[0];
    private final Team team;
    private final MortonKeys[] keys; // by share
    private final Work boxing = this::findBoxOfShare;
    private final Work keying = this::giveKeysToShare;
    private int bits; // of a digit, in the sort of the moment

    private int nodes;
    private double[] nodeMinX = new double[16];
    private double[] nodeMinY = new double[16];
    private double[] nodeMaxX = new double[16];
    private double[] nodeMaxY = new double[16];
    private int[] past = new int[16]; // the node behind the subtree
    private int[] first = new int[16]; // the run of items of the node
    private int[] end = new int[16];
    private int[] leafFirst = new int[16]; // first for a leaf, −1 for an inner node: a query looks at one number there

    private int[] found = new int[16];

    public Quadtree() {
        this(DEFAULT_LEAF_SIZE);
    }

    /** A tree whose nodes are divided as long as they hold more items than this. */
    public Quadtree(int leafSize) {
        this(leafSize, true, Team.ofOne(), new Workspace());
    }

    private Quadtree(int leafSize, boolean hasBoxes, Team team, Workspace workspace) {
        this.leafSize = leafSize;
        this.hasBoxes = hasBoxes;
        this.team = team;
        this.workspace = workspace;
        this.keys = new MortonKeys[Math.min(MOST_SHARES, 2 * team.size() - 1)];
        Arrays.setAll(keys, share -> new MortonKeys());
    }

    /**
     * A tree of points, set by {@link #setPoint} alone, for sums over its nodes: these have no boxes, which take half as long as all the
     * rest, and cannot be queried. A team gives many of them their keys. When it is built, the columns 0 and 1 of the workspace,
     * where the points stood, are free.
     */
    public static Quadtree ofPoints(int leafSize, Team team, Workspace workspace) {
        return new Quadtree(leafSize, false, team, workspace);
    }

    /** Forgets everything and makes room for this many items. */
    public void begin(int items) {
        count = items;
        nodes = 0;
        workspace.take(this);
        minX = workspace.doubles(0, items);
        minY = workspace.doubles(1, items);
        maxX = hasBoxes ? workspace.doubles(2, items) : minX;
        maxY = hasBoxes ? workspace.doubles(3, items) : minY;
        item = workspace.ints(0, items);
        key = workspace.ints(1, items);
        spareItem = workspace.ints(2, items);
        spareKey = workspace.ints(3, items);
    }

    /** The box of one item; all numbers finite. */
    public void set(int item, double boxMinX, double boxMinY, double boxMaxX, double boxMaxY) {
        minX[item] = boxMinX;
        minY[item] = boxMinY;
        maxX[item] = boxMaxX;
        maxY[item] = boxMaxY;
    }

    /** The place of one item that is a point; finite. */
    public void setPoint(int item, double x, double y) {
        minX[item] = x;
        minY[item] = y;
    }

    /** Sorts the items and builds the nodes. */
    public void build() {
        for (int i = 0; i < count; i++) {
            item[i] = i;
        }
        if (count > 0 && sort(0, count)) {
            addNode(0, count, 0);
        } else if (count > 0) {
            addLeaf(0, count);
        }
    }

    /** Sorts a run along the Z-order curve within its own box; false when all its centres are one, or not to be told apart. */
    private boolean sort(int start, int stop) {
        bits = stop - start < MANY ? NARROW : WIDE;
        boolean shared = stop - start == count && count >= MANY_FOR_A_TEAM && keys.length > 1;
        MortonKeys all = keys[0];
        if (shared) {
            team.share(boxing, keys.length);
            for (int share = 1; share < keys.length; share++) {
                all.join(keys[share]);
            }
        } else {
            all.findBox(this, start, stop);
        }
        double scale = all.scale();
        if (scale == 0 || Double.isInfinite(scale)) {
            return false;
        }
        if (shared) {
            team.share(keying, keys.length);
            for (int share = 1; share < keys.length; share++) {
                all.add(keys[share], bits);
            }
        } else {
            all.giveKeys(this, all, start, stop, bits);
        }
        sortByDigit(all.histogram, 0, start, stop, 2 * LEVELS - 2 * bits);
        sortByDigit(all.histogram, 1 << bits, start, stop, 2 * LEVELS - bits);
        return true;
    }

    private void findBoxOfShare(int share, int member) {
        keys[share].findBox(this, beginningOf(share), beginningOf(share + 1));
    }

    private void giveKeysToShare(int share, int member) {
        keys[share].giveKeys(this, keys[0], beginningOf(share), beginningOf(share + 1), bits);
    }

    private int beginningOf(int share) {
        return Team.beginning(share, keys.length, count);
    }

    double centreX(int item) {
        return 0.5 * minX[item] + 0.5 * maxX[item];
    }

    double centreY(int item) {
        return 0.5 * minY[item] + 0.5 * maxY[item];
    }

    /**
     * One pass of a radix sort, an even number of which ends in the arrays where it began; stable, so equal keys stay in the order
     * they had.
     *
     * @param from where the digit begins in the histogram
     * @param shift where it begins in the key
     */
    private void sortByDigit(int[] histogram, int from, int start, int stop, int shift) {
        int place = start;
        for (int value = from; value < from + (1 << bits); value++) {
            int equal = histogram[value];
            histogram[value] = place;
            place += equal;
        }
        int mask = (1 << bits) - 1;
        for (int p = start; p < stop; p++) {
            int at = histogram[from + (key[p] >>> shift & mask)]++;
            spareKey[at] = key[p];
            spareItem[at] = item[p];
        }
        int[] sorted = spareKey;
        spareKey = key;
        key = sorted;
        sorted = spareItem;
        spareItem = item;
        item = sorted;
    }

    /** Adds the node of a run of the order, and everything below it. */
    private void addNode(int start, int stop, int level) {
        int depth = level;
        while (stop - start > leafSize && depth < LEVELS && digit(start, depth) == digit(stop - 1, depth)) {
            depth++; // all in one quarter: no chain of single children
        }
        if (stop - start <= leafSize) {
            addLeaf(start, stop);
        } else if (depth < LEVELS) {
            addChildren(start, stop, depth);
        } else if (sort(start, stop)) {
            addNode(start, stop, 0);
        } else {
            addLeaf(start, stop);
        }
    }

    private void addChildren(int start, int stop, int depth) {
        int node = openNode(start, stop);
        leafFirst[node] = -1;
        int begin = start;
        while (begin < stop) {
            int next = endOfQuarter(begin, stop, depth);
            addNode(begin, next, depth + 1);
            begin = next;
        }
        past[node] = nodes;
        if (hasBoxes) {
            boxOfChildren(node);
        }
    }

    /** Where the run of items in the quarter of the first one ends: found by halving, keys being sorted. */
    private int endOfQuarter(int start, int stop, int depth) {
        int quarter = digit(start, depth);
        int inside = start;
        int outside = stop;
        while (outside - inside > 1) {
            int middle = (inside + outside) >>> 1;
            if (digit(middle, depth) == quarter) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        return outside;
    }

    private void addLeaf(int start, int stop) {
        int node = openNode(start, stop);
        leafFirst[node] = start;
        past[node] = nodes;
        if (hasBoxes) {
            boxOfItems(node, start, stop);
        }
    }

    private int openNode(int start, int stop) {
        int node = nodes++;
        if (node == past.length) {
            growNodes(node + node / 2);
        }
        first[node] = start;
        end[node] = stop;
        return node;
    }

    private int digit(int position, int depth) {
        return key[position] >>> (30 - 2 * depth) & 3;
    }

    private void boxOfItems(int node, int start, int stop) {
        double lowX = Double.POSITIVE_INFINITY;
        double lowY = Double.POSITIVE_INFINITY;
        double highX = Double.NEGATIVE_INFINITY;
        double highY = Double.NEGATIVE_INFINITY;
        for (int p = start; p < stop; p++) {
            int i = item(p);
            lowX = Math.min(lowX, minX[i]);
            lowY = Math.min(lowY, minY[i]);
            highX = Math.max(highX, maxX[i]);
            highY = Math.max(highY, maxY[i]);
        }
        setBox(node, lowX, lowY, highX, highY);
    }

    private void boxOfChildren(int node) {
        double lowX = Double.POSITIVE_INFINITY;
        double lowY = Double.POSITIVE_INFINITY;
        double highX = Double.NEGATIVE_INFINITY;
        double highY = Double.NEGATIVE_INFINITY;
        for (int child = node + 1; child < past[node]; child = past[child]) {
            lowX = Math.min(lowX, nodeMinX[child]);
            lowY = Math.min(lowY, nodeMinY[child]);
            highX = Math.max(highX, nodeMaxX[child]);
            highY = Math.max(highY, nodeMaxY[child]);
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
        if (hasBoxes) {
            nodeMinX = Arrays.copyOf(nodeMinX, capacity);
            nodeMinY = Arrays.copyOf(nodeMinY, capacity);
            nodeMaxX = Arrays.copyOf(nodeMaxX, capacity);
            nodeMaxY = Arrays.copyOf(nodeMaxY, capacity);
        }
        past = Arrays.copyOf(past, capacity);
        first = Arrays.copyOf(first, capacity);
        end = Arrays.copyOf(end, capacity);
        leafFirst = Arrays.copyOf(leafFirst, capacity);
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
            for (int p = leafFirst[node]; p >= 0 && p < end[node]; p++) {
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

    // --- the tree itself, for sums over its nodes; node 0 is the root, parents stand before their children ---

    /** How many nodes there are; 0 when there are no items. */
    public int nodes() {
        return nodes;
    }

    /** The node behind everything below this one. */
    public int past(int node) {
        return past[node];
    }

    public boolean isLeaf(int node) {
        return past[node] == node + 1;
    }

    /** The position of the first item of a node in the order of the tree. */
    public int first(int node) {
        return first[node];
    }

    /** The position behind the last item of a node in the order of the tree. */
    public int end(int node) {
        return end[node];
    }

    /** How many items are below a node. */
    public int size(int node) {
        return end[node] - first[node];
    }

    /** How many items there are. */
    public int items() {
        return count;
    }

    /** The item at a position of the order of the tree. */
    public int item(int position) {
        return item[position];
    }
}

package io.github.apsis.engine.spatial;

import io.github.apsis.engine.math.Period;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Circles of any size and which of them touch: {@link #begin}, {@link #set} for every circle, {@link #build}, then
 * {@link #findPairs}; and where some change later {@link #move}, and {@link #query} for what touches one.
 *
 * <p>A circle belongs to a grid whose cells are as wide as it is, or up to four times as wide, so it reaches half a cell beyond
 * its own at most and meets circles of its grid in the eight cells around alone; grids of other sizes are asked around it. Cells
 * are numbered row by row and circles sorted by their cells in one count (Knuth 1973, TAOCP 3, 5.2): three neighbours in a row
 * are one run of memory. A plane is folded up into a torus of four cells for each circle, or up to eight, so what has flown off
 * costs nothing; circles that are neighbours only by the fold are told apart by their distance.
 *
 * <p>25 ns a circle for sorting and all pairs where all are of one size, twice that where radii are spread evenly from 1 to 100,
 * four times where their logarithms are. Nothing is allocated once warm.
 */
public final class CircleGrid {
    private static final int LEVELS = 128;
    private static final int MIDDLE = 80; // the level of most circles
    private static final int TOP = LEVELS - 1; // one cell, for all that is larger

    /** Cells are so much wider than most circles: some grow when paths are bent. */
    private static final double ROOM = 1.15;

    /** Of a cell: what the numbers of rows and columns lose to rounding is less, see {@link #ROUNDING}. */
    private static final double MARGIN = 0x1p-10;

    /** Of the coordinates, added to each circle: so a row or a column never has a number beyond 2³⁹. */
    private static final double ROUNDING = 0x1p-40;

    /** So far circles reach beyond their cells when they have been sorted, in cells. */
    private static final double SORTED = 0.5 + MARGIN;

    /** So far they may reach after they have been moved. */
    private static final double MOVED = 0.75;

    private static final double SMALLEST = 0x1p-800;
    private static final double LARGEST = 0x1p900;

    private static final int SAMPLE = 64; // circles that tell the size of most
    private static final int FEWEST_COLUMNS = 4; // on a torus of two, a cell is its own neighbour's neighbour
    private static final int AT_ONCE = 4096; // neighbours are compared before there are more
    private static final int FEW_STRAYS = 32;
    private static final double MOST_STRAYS =
            4; // times the root of all: then sorting anew is cheaper than looking at each

    private final @Nullable Period period;

    private int count;
    private double[] x = new double[16]; // as they were sorted
    private double[] y = new double[16];
    private double[] reach = new double[16];
    private int[] level = new int[16];
    private int[] cell = new int[16];
    private int[] place = new int[16]; // in the order of the cells

    private final int[] sampled = new int[2048]; // by exponent
    private final double[] sampledReach = new double[2048];
    private final int[] size = new int[LEVELS]; // circles of each level
    private final int[] used = new int[LEVELS]; // the levels that have any, fine ones first
    private int levels;
    private double unit; // the side of cells in the middle level, length
    private final double[] side = new double[LEVELS];
    private final double[] columnsPerLength = new double[LEVELS];
    private final double[] rowsPerLength = new double[LEVELS];
    private final int[] columns = new int[LEVELS];
    private final int[] rows = new int[LEVELS];
    private final int[] firstCell = new int[LEVELS];
    private int[] start = new int[64]; // by cell: the place of its first circle

    // By place.
    private int[] circle = new int[16];
    private int[] home = new int[16]; // its cell
    private double[] at = new double[64]; // x, y, radius (NaN of a stray), nothing

    // Circles that reach farther from their cells than when they were sorted.
    private int strays;
    private int[] stray = new int[FEW_STRAYS];
    private double[] strayX = new double[FEW_STRAYS];
    private double[] strayY = new double[FEW_STRAYS];
    private double[] strayReach = new double[FEW_STRAYS];

    // Circles in neighbouring cells, as places: gathered first and compared after, each in a loop whose branches can be
    // foretold.
    private int neighbours;
    private long[] neighbour = new long[AT_ONCE]; // place << 32 | other place

    private int[] found = new int[16];
    private int pairs;
    private int[] first = new int[64];
    private int[] second = new int[64];

    /** A grid over a plane, or over a world that repeats itself: there a circle meets the nearest image of another. */
    public CircleGrid(@Nullable Period period) {
        this.period = period;
    }

    /** Forgets everything and makes room for so many circles. */
    public void begin(int circles) {
        count = circles;
        if (circles > x.length) {
            int capacity = Math.max(circles, 2 * x.length);
            x = new double[capacity];
            y = new double[capacity];
            reach = new double[capacity];
            level = new int[capacity];
            cell = new int[capacity];
            place = new int[capacity];
            circle = new int[capacity];
            home = new int[capacity];
            at = new double[4 * capacity];
        }
    }

    /** One circle; all numbers finite. */
    public void set(int i, double centreX, double centreY, double radius) {
        x[i] = period == null ? centreX : period.insideX(centreX);
        y[i] = period == null ? centreY : period.insideY(centreY);
        reach[i] = withRounding(centreX, centreY, radius);
    }

    private static double withRounding(double centreX, double centreY, double radius) {
        return radius + ROUNDING * (radius + Math.abs(centreX) + Math.abs(centreY));
    }

    /** Sorts the circles. */
    public void build() {
        strays = 0;
        unit = 2 * ROOM * usualReach();
        chooseLevels();
        int cells = layOut();
        sort(cells);
    }

    /** The mean of a sample, without those that differ by more than their exponent from most. */
    private double usualReach() {
        int step = Math.max(1, count / SAMPLE);
        int most = 0;
        for (int i = 0; i < count; i += step) {
            int exponent = Math.getExponent(reach[i]) + 1023;
            if (reach[i] > 0) {
                sampled[exponent]++;
                sampledReach[exponent] += reach[i];
                most = sampled[exponent] > sampled[most] ? exponent : most;
            }
        }
        double mean = sampled[most] == 0 ? 1 : sampledReach[most] / sampled[most];
        for (int i = 0; i < count; i += step) {
            int exponent = Math.getExponent(reach[i]) + 1023;
            sampled[exponent] = 0;
            sampledReach[exponent] = 0;
        }
        return Math.max(SMALLEST, Math.min(LARGEST, mean));
    }

    private void chooseLevels() {
        Arrays.fill(size, 0);
        double scale = 2 * (1 + 2 * MARGIN) / unit;
        for (int i = 0; i < count; i++) {
            int l = Math.max(0, Math.min(TOP, MIDDLE + (Math.getExponent(reach[i] * scale) >> 1) + 1));
            level[i] = l;
            size[l]++;
        }
        levels = 0;
        for (int l = 0; l < LEVELS; l++) {
            if (size[l] > 0) {
                used[levels++] = l;
            }
        }
    }

    /** Gives each level its cells, four times as many as circles or more, and returns how many there are. */
    private int layOut() {
        int cells = 0;
        for (int k = 0; k < levels; k++) {
            int l = used[k];
            side[l] = l == TOP ? Double.POSITIVE_INFINITY : unit * Math.scalb(1.0, 2 * (l - MIDDLE));
            if (period == null) {
                fold(l);
            } else {
                divide(l, period);
            }
            firstCell[l] = cells;
            cells += columns[l] * rows[l];
        }
        return cells;
    }

    private void fold(int l) {
        int wanted = 4 * size[l];
        int across = FEWEST_COLUMNS;
        while (across * across < wanted) {
            across *= 2;
        }
        columns[l] = l == TOP ? 1 : across;
        rows[l] = l == TOP ? 1 : Math.max(FEWEST_COLUMNS, across * across / 2 < wanted ? across : across / 2);
        columnsPerLength[l] = 1 / side[l];
        rowsPerLength[l] = 1 / side[l];
    }

    private void divide(int l, Period world) {
        double across = Math.floor(world.width() / side[l]);
        double up = Math.floor(world.height() / side[l]);
        double shrink = Math.max(1, Math.sqrt(across * up / (4.0 * size[l] + FEWEST_COLUMNS * FEWEST_COLUMNS)));
        columns[l] = divisions(across / shrink);
        rows[l] = divisions(up / shrink);
        columnsPerLength[l] = columns[l] / world.width();
        rowsPerLength[l] = rows[l] / world.height();
    }

    /** Fewer than three would be neighbours on both sides. */
    private static int divisions(double most) {
        return most < 3 ? 1 : (int) most;
    }

    /** The number of a row or column on the torus. */
    private int fold(double number, int of) {
        return period == null ? (int) (long) number & of - 1 : (int) Math.floorMod((long) number, of);
    }

    private void sort(int cells) {
        if (cells >= start.length) {
            start = new int[Math.max(cells + 1, 2 * start.length)];
        }
        Arrays.fill(start, 0, cells + 1, 0);
        for (int i = 0; i < count; i++) {
            int l = level[i];
            int column = fold(Math.floor(x[i] * columnsPerLength[l]), columns[l]);
            int row = fold(Math.floor(y[i] * rowsPerLength[l]), rows[l]);
            int c = firstCell[l] + row * columns[l] + column;
            cell[i] = c;
            start[c]++;
        }
        int end = 0;
        for (int c = 0; c <= cells; c++) {
            end += start[c];
            start[c] = end;
        }
        for (int i = count - 1; i >= 0; i--) {
            int p = --start[cell[i]];
            place[i] = p;
            circle[p] = i;
            home[p] = cell[i];
            at[4 * p + 0] = x[i];
            at[4 * p + 1] = y[i];
            at[4 * p + 2] = reach[i];
        }
    }

    /**
     * Finds all pairs of circles that touch, rims included, each once; {@link #first} and {@link #second} give them, the lower
     * number first.
     *
     * @return how many
     */
    public int findPairs() {
        pairs = 0;
        for (int k = 0; k < levels; k++) {
            pairWithin(used[k]);
            for (int m = k + 1; m < levels; m++) {
                pairAcross(used[k], used[m]);
            }
        }
        return pairs;
    }

    /** Pairs of one level: each circle with those behind it in its cell, with the cell to the right, and with three of the next row. */
    private void pairWithin(int l) {
        int across = columns[l];
        for (int row = 0; row < rows[l]; row++) {
            int here = firstCell[l] + row * across;
            int next = row + 1 < rows[l] ? here + across : firstCell[l];
            int last = start[here + across];
            for (int p = start[here]; p < last; p++) {
                int column = home[p] - here;
                if (column > 0 && column < across - 1 && next != here) {
                    gather(p, start[here + column + 2], start[next + column - 1], start[next + column + 2]);
                } else {
                    gatherAtSeam(p, column, across, here, next);
                }
            }
            compare();
        }
    }

    private void gatherAtSeam(int p, int column, int across, int here, int next) {
        gather(p, p + 1, start[here + Math.min(across, column + 2)]);
        if (across > 1 && column == across - 1) {
            gather(p, start[here], start[here + 1]);
        }
        if (next != here) {
            gatherThree(p, column, across, next);
        }
    }

    /** The cell in this column of a row, and those beside it. */
    private void gatherThree(int p, int column, int across, int row) {
        gather(p, start[row + Math.max(0, column - 1)], start[row + Math.min(across, column + 2)]);
        if (across > 1 && column == 0) {
            gather(p, start[row + across - 1], start[row + across]);
        }
        if (across > 1 && column == across - 1) {
            gather(p, start[row], start[row + 1]);
        }
    }

    /**
     * Notes two runs of places as neighbours of another: from behind it to an end, and from a beginning to an end. Most are
     * shorter than three, and how long they are is past guessing: to write three and keep what is in the run is faster.
     */
    private void gather(int p, int end, int from, int to) {
        if (end - p > 3 || to - from > 3 || neighbours + 5 > neighbour.length) {
            gather(p, p + 1, end);
            gather(p, from, to);
            return;
        }
        long[] list = neighbour;
        long place = (long) p << 32;
        int k = neighbours;
        list[k] = place | p + 1;
        k += p + 1 - end >>> 31; // 1 below the end
        list[k] = place | p + 2;
        k += p + 2 - end >>> 31;
        list[k] = place | from;
        k += from - to >>> 31;
        list[k] = place | from + 1;
        k += from + 1 - to >>> 31;
        list[k] = place | from + 2;
        k += from + 2 - to >>> 31;
        neighbours = k;
    }

    /** Notes a run of places as neighbours of another. */
    private void gather(int p, int from, int to) {
        if (neighbours + to - from + 3 > neighbour.length) {
            neighbour = Arrays.copyOf(neighbour, Math.max(neighbours + to - from + 3, 2 * neighbour.length));
        }
        long[] list = neighbour;
        long place = (long) p << 32;
        int k = neighbours;
        list[k] = place | from;
        k += from - to >>> 31;
        list[k] = place | from + 1;
        k += from + 1 - to >>> 31;
        list[k] = place | from + 2;
        k += from + 2 - to >>> 31;
        for (int q = from + 3; q < to; q++) {
            list[k++] = place | q;
        }
        neighbours = k;
    }

    /** Makes pairs of the neighbours that touch. */
    private void compare() {
        if (pairs + neighbours > first.length) {
            int capacity = Math.max(pairs + neighbours, 2 * first.length);
            first = Arrays.copyOf(first, capacity);
            second = Arrays.copyOf(second, capacity);
        }
        int k = pairs;
        for (int n = 0; n < neighbours; n++) {
            int p = (int) (neighbour[n] >>> 32);
            int q = (int) neighbour[n];
            first[k] = Math.min(circle[p], circle[q]);
            second[k] = Math.max(circle[p], circle[q]);
            k += touch(at[4 * q + 0] - at[4 * p + 0], at[4 * q + 1] - at[4 * p + 1], at[4 * q + 2] + at[4 * p + 2])
                    ? 1
                    : 0;
        }
        pairs = k;
        neighbours = 0;
    }

    private boolean touch(double dx, double dy, double distance) {
        double ex = dx;
        double ey = dy;
        if (period != null) {
            ex = nearest(dx, period.width());
            ey = nearest(dy, period.height());
        }
        return ex * ex + ey * ey <= distance * distance;
    }

    /** Of the difference of two coordinates within one period. */
    private static double nearest(double difference, double width) {
        double size = Math.abs(difference);
        return Math.min(size, width - size);
    }

    /** Pairs of two levels, asked for by that for which it is cheaper: few large circles, or small ones. */
    private void pairAcross(int fine, int coarse) {
        double runs = Math.min(rows[fine], 2 + 1.5 * side[coarse] / side[fine]);
        boolean fromCoarse = size[coarse] * runs < size[fine] * 3.0;
        int from = fromCoarse ? coarse : fine;
        int to = fromCoarse ? fine : coarse;
        int end = start[firstCell[from] + columns[from] * rows[from]];
        for (int p = start[firstCell[from]]; p < end; p++) {
            gatherAround(p, to, at[4 * p + 0], at[4 * p + 1], at[4 * p + 2], SORTED);
            compareWhenMany();
        }
        compare();
    }

    private void compareWhenMany() {
        if (neighbours > AT_ONCE / 2) {
            compare();
        }
    }

    /** Gathers the cells of a level that hold what may touch this circle. */
    private void gatherAround(int p, int l, double cx, double cy, double r, double overhang) {
        double left = Math.floor((cx - r) * columnsPerLength[l] - overhang);
        double right = Math.floor((cx + r) * columnsPerLength[l] + overhang);
        double low = Math.floor((cy - r) * rowsPerLength[l] - overhang);
        double high = Math.floor((cy + r) * rowsPerLength[l] + overhang);
        int across = columns[l];
        int from = 0;
        int to = across;
        if (right - left + 1 < across) {
            from = fold(left, across);
            to = from + (int) (right - left) + 1;
        }
        int row = 0;
        int rowsLeft = rows[l];
        if (high - low + 1 < rowsLeft) {
            row = fold(low, rowsLeft);
            rowsLeft = (int) (high - low) + 1;
        }
        for (; rowsLeft > 0; rowsLeft--) {
            int here = firstCell[l] + row * across;
            gather(p, start[here + from], start[here + Math.min(to, across)]);
            if (to > across) {
                gather(p, start[here], start[here + to - across]);
            }
            row = row + 1 < rows[l] ? row + 1 : 0;
        }
    }

    /**
     * Finds the circles, as they are now, that touch this one, each once and itself among them; {@link #found} gives them, until
     * the next query.
     *
     * @return how many
     */
    public int query(int i) {
        int p = place[i];
        boolean isStray = home[p] < 0;
        double cx = isStray ? strayX[-1 - home[p]] : at[4 * p];
        double cy = isStray ? strayY[-1 - home[p]] : at[4 * p + 1];
        double r = isStray ? strayReach[-1 - home[p]] : at[4 * p + 2];
        for (int k = 0; k < levels; k++) {
            gatherAround(0, used[k], cx, cy, r, MOVED + MARGIN);
        }
        if (neighbours + strays > found.length) {
            found = new int[Math.max(neighbours + strays, 2 * found.length)];
        }
        int hits = 0;
        for (int n = 0; n < neighbours; n++) {
            int q = (int) neighbour[n];
            found[hits] = circle[q];
            hits += touch(at[4 * q + 0] - cx, at[4 * q + 1] - cy, at[4 * q + 2] + r) ? 1 : 0;
        }
        neighbours = 0;
        for (int s = 0; s < strays; s++) {
            found[hits] = stray[s];
            hits += touch(strayX[s] - cx, strayY[s] - cy, strayReach[s] + r) ? 1 : 0;
        }
        return hits;
    }

    /** The {@code hit}-th circle of the last query. */
    public int found(int hit) {
        return found[hit];
    }

    /** The lower number of the {@code k}-th pair. */
    public int first(int k) {
        return first[k];
    }

    /** The higher number of the {@code k}-th pair. */
    public int second(int k) {
        return second[k];
    }

    /** Changes a circle after {@link #build}. */
    public void move(int i, double centreX, double centreY, double radius) {
        double newX = period == null ? centreX : period.insideX(centreX);
        double newY = period == null ? centreY : period.insideY(centreY);
        double newReach = withRounding(centreX, centreY, radius);
        int p = place[i];
        if (home[p] < 0) {
            setStray(-1 - home[p], i, newX, newY, newReach);
        } else if (keepsToCell(i, newX, newY, newReach)) {
            at[4 * p] = newX;
            at[4 * p + 1] = newY;
            at[4 * p + 2] = newReach;
        } else {
            home[p] = -1 - strays;
            at[4 * p + 2] = Double.NaN;
            growStrays();
            setStray(strays++, i, newX, newY, newReach);
            if (strays > FEW_STRAYS && (double) strays * strays > MOST_STRAYS * MOST_STRAYS * count) {
                sortAnew();
            }
        }
    }

    /** Whether a circle is still near its cell, of which no more is known than that its centre was there when it was sorted. */
    private boolean keepsToCell(int i, double newX, double newY, double newReach) {
        double dx = Math.abs(newX - x[i]);
        double dy = Math.abs(newY - y[i]);
        if (period != null) {
            dx = nearest(dx, period.width());
            dy = nearest(dy, period.height());
        }
        return Math.max(dx, dy) + newReach <= MOVED * side[level[i]];
    }

    private void sortAnew() {
        for (int p = 0; p < count; p++) {
            x[circle[p]] = at[4 * p];
            y[circle[p]] = at[4 * p + 1];
            reach[circle[p]] = at[4 * p + 2];
        }
        for (int s = 0; s < strays; s++) {
            x[stray[s]] = strayX[s];
            y[stray[s]] = strayY[s];
            reach[stray[s]] = strayReach[s];
        }
        build();
    }

    private void setStray(int s, int i, double newX, double newY, double newReach) {
        stray[s] = i;
        strayX[s] = newX;
        strayY[s] = newY;
        strayReach[s] = newReach;
    }

    private void growStrays() {
        if (strays == stray.length) {
            stray = Arrays.copyOf(stray, 2 * strays);
            strayX = Arrays.copyOf(strayX, 2 * strays);
            strayY = Arrays.copyOf(strayY, 2 * strays);
            strayReach = Arrays.copyOf(strayReach, 2 * strays);
        }
    }
}

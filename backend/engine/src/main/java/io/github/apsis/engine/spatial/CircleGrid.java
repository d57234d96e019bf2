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
 * are one run of memory. A plane is folded up into a torus of three cells for each circle, or up to six, so what has flown off
 * costs nothing; circles that are neighbours only by the fold are told apart by their distance.
 *
 * <p>17 to 26 ns a circle, of 1000 and of 5000, for sorting and all pairs where all are of one size; up to twice and a half that
 * where radii go from 1 to 100 with a density falling as r⁻³. Nothing is allocated once warm.
 */
public final class CircleGrid {
    private static final int LEVELS = 128;
    private static final int MIDDLE = 80; // the level of most circles
    private static final int TOP = LEVELS - 1; // one cell, for all that is larger

    /** Cells are so much wider than most circles: some grow when paths are bent. */
    private static final double ROOM = 1.22;

    /** Of a cell: what the numbers of rows and columns lose to rounding is less, see {@link #ROUNDING}. */
    private static final double MARGIN = 0x1p-10;

    /** Of the coordinates, added to each circle: so a row or a column never has a number beyond 2³⁹. */
    private static final double ROUNDING = 0x1p-40;

    /** So far circles reach beyond their cells, in cells. */
    private static final double OVERHANG = 0.5;

    private static final double SMALLEST = 0x1p-800;
    private static final double LARGEST = 0x1p900;

    private static final int SAMPLE = 64; // circles that tell the size of most
    private static final int CELLS = 3; // for each circle, or up to twice as many
    private static final int FEWEST_COLUMNS = 4; // on a torus of two, a cell is its own neighbour's neighbour
    private static final int AT_ONCE = 4096; // neighbours are compared before there are more
    private static final int FEW_STRAYS = 32;
    private static final double MOST_STRAYS =
            4; // times the root of all: then sorting anew is cheaper than looking at each

    private final @Nullable Period period;

    private int count;
    private double[] x = new double[16]; // as they were set
    private double[] y = new double[16];
    private double[] reach = new double[16];
    private int[] place = new int[16]; // in the order of the cells; before it is known, level and cell

    private final int[] sampled = new int[2048]; // by exponent
    private final double[] sampledReach = new double[2048];
    private final int[] size = new int[LEVELS]; // circles of each level
    private final int[] used = new int[LEVELS]; // the levels that have any, fine ones first
    private int levels;
    private int cells;
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
    private double[] at = new double[57]; // x, y, radius (NaN of a stray)

    // Circles that reach farther from their cells than when they were sorted.
    private int strays;
    private int[] stray = new int[FEW_STRAYS];
    private double[] strayX = new double[FEW_STRAYS];
    private double[] strayY = new double[FEW_STRAYS];
    private double[] strayReach = new double[FEW_STRAYS];

    // Circles in neighbouring cells, as places: gathered first and compared after, each in a loop whose branches can be
    // foretold.
    private int neighbours;
    private long[] neighbour = new long[64]; // place << 32 | other place

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
            int capacity = Math.max(circles, x.length + x.length / 8);
            x = new double[capacity];
            y = new double[capacity];
            reach = new double[capacity];
            place = new int[capacity];
            circle = new int[capacity];
            home = new int[capacity];
            at = new double[3 * (capacity + 3)]; // a look at three goes beyond the last
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
        if (!sortAsOneLevel()) {
            chooseLevels();
            sort();
        }
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

    /** Where most are of one size all may be: then they are sorted while that is looked at. */
    private boolean sortAsOneLevel() {
        Arrays.fill(size, 0);
        size[MIDDLE] = count;
        used[0] = MIDDLE;
        levels = 1;
        prepareCells();
        double most = 0.5 * unit / (1 + 2 * MARGIN);
        double least = 0.25 * most;
        double acrossPerLength = columnsPerLength[MIDDLE];
        double upPerLength = rowsPerLength[MIDDLE];
        int across = columns[MIDDLE];
        int up = rows[MIDDLE];
        for (int i = 0; i < count; i++) {
            if (!(reach[i] >= least && reach[i] < most)) {
                return false;
            }
            int c = fold(Math.floor(y[i] * upPerLength), up) * across
                    + fold(Math.floor(x[i] * acrossPerLength), across);
            place[i] = c;
            start[c]++;
        }
        scatter();
        return true;
    }

    private void chooseLevels() {
        Arrays.fill(size, 0);
        double scale = 2 * (1 + 2 * MARGIN) / unit;
        for (int i = 0; i < count; i++) {
            int l = Math.max(0, Math.min(TOP, MIDDLE + (Math.getExponent(reach[i] * scale) >> 1) + 1));
            place[i] = l;
            size[l]++;
        }
        levels = 0;
        for (int l = 0; l < LEVELS; l++) {
            if (size[l] > 0) {
                used[levels++] = l;
            }
        }
    }

    /** Gives each level its cells, three times as many as circles or more, all empty. */
    private void prepareCells() {
        cells = 0;
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
        if (cells >= start.length) {
            start = new int[cells + 1];
        }
        Arrays.fill(start, 0, cells + 1, 0);
    }

    private void fold(int l) {
        int wanted = CELLS * size[l];
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
        double shrink =
                Math.max(1, Math.sqrt(across * up / (CELLS * (double) size[l] + FEWEST_COLUMNS * FEWEST_COLUMNS)));
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

    private void sort() {
        prepareCells();
        for (int i = 0; i < count; i++) {
            int l = place[i];
            int column = fold(Math.floor(x[i] * columnsPerLength[l]), columns[l]);
            int row = fold(Math.floor(y[i] * rowsPerLength[l]), rows[l]);
            int c = firstCell[l] + row * columns[l] + column;
            place[i] = c;
            start[c]++;
        }
        scatter();
    }

    /** Puts all circles, whose cells have been counted, into the order of these. */
    private void scatter() {
        int end = 0;
        for (int c = 0; c <= cells; c++) {
            end += start[c];
            start[c] = end;
        }
        for (int i = count - 1; i >= 0; i--) {
            int c = place[i];
            int p = --start[c];
            place[i] = p;
            circle[p] = i;
            home[p] = c;
            at[3 * p] = x[i];
            at[3 * p + 1] = y[i];
            at[3 * p + 2] = reach[i];
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
                    compareWithRuns(p, start[here + column + 2], start[next + column - 1], start[next + column + 2]);
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
     * Compares a place with two runs of others: from behind it to an end, and from a beginning to an end. Most are shorter than
     * three, and how long they are is past guessing: to compare with two and three, and keep what is in the run, is faster.
     */
    private void compareWithRuns(int p, int end, int from, int to) {
        if (end - p <= 3 && to - from <= 3 && period == null) {
            double[] a = at;
            double px = a[3 * p];
            double py = a[3 * p + 1];
            double pr = a[3 * p + 2];
            long apart = apart(a, p + 1, px, py, pr)
                    & apart(a, p + 2, px, py, pr)
                    & apart(a, from, px, py, pr)
                    & apart(a, from + 1, px, py, pr)
                    & apart(a, from + 2, px, py, pr);
            if (apart < 0) {
                return;
            }
        }
        compareWithRun(p, p + 1, end);
        compareWithRun(p, from, to);
    }

    /** Negative when two do not touch: the sign of a difference, which is no branch. */
    private static long apart(double[] a, int q, double px, double py, double pr) {
        double dx = a[3 * q] - px;
        double dy = a[3 * q + 1] - py;
        double distance = a[3 * q + 2] + pr;
        return Double.doubleToRawLongBits(distance * distance - (dx * dx + dy * dy));
    }

    private void compareWithRun(int p, int from, int to) {
        for (int q = from; q < to; q++) {
            if (touch(at[3 * q] - at[3 * p], at[3 * q + 1] - at[3 * p + 1], at[3 * q + 2] + at[3 * p + 2])) {
                add(p, q);
            }
        }
    }

    private void add(int p, int q) {
        if (pairs == first.length) {
            first = Arrays.copyOf(first, 2 * pairs);
            second = Arrays.copyOf(second, 2 * pairs);
        }
        first[pairs] = Math.min(circle[p], circle[q]);
        second[pairs++] = Math.max(circle[p], circle[q]);
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
        long[] list = neighbour;
        int touching = 0;
        for (int n = 0; n < neighbours; n++) {
            long both = list[n];
            int p = 3 * (int) (both >>> 32);
            int q = 3 * (int) both;
            list[touching] = both;
            touching += touch(at[q] - at[p], at[q + 1] - at[p + 1], at[q + 2] + at[p + 2]) ? 1 : 0;
        }
        neighbours = 0;
        for (int n = 0; n < touching; n++) {
            add((int) (list[n] >>> 32), (int) list[n]);
        }
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
            gatherAround(p, to, at[3 * p], at[3 * p + 1], at[3 * p + 2]);
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
    private void gatherAround(int p, int l, double cx, double cy, double r) {
        double overhang = OVERHANG + MARGIN;
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
        double cx = isStray ? strayX[-1 - home[p]] : at[3 * p];
        double cy = isStray ? strayY[-1 - home[p]] : at[3 * p + 1];
        double r = isStray ? strayReach[-1 - home[p]] : at[3 * p + 2];
        int own = isStray ? -1 : levelOf(home[p]);
        for (int k = 0; k < levels; k++) {
            if (used[k] != own || !gatherBeside(home[p], own)) {
                gatherAround(0, used[k], cx, cy, r);
            }
        }
        if (neighbours + strays > found.length) {
            found = new int[Math.max(neighbours + strays, 2 * found.length)];
        }
        int hits = 0;
        for (int n = 0; n < neighbours; n++) {
            int q = (int) neighbour[n];
            found[hits] = circle[q];
            hits += touch(at[3 * q] - cx, at[3 * q + 1] - cy, at[3 * q + 2] + r) ? 1 : 0;
        }
        neighbours = 0;
        for (int s = 0; s < strays; s++) {
            found[hits] = stray[s];
            hits += touch(strayX[s] - cx, strayY[s] - cy, strayReach[s] + r) ? 1 : 0;
        }
        return hits;
    }

    /** Gathers a cell and the eight around it; false at the seam. */
    private boolean gatherBeside(int cell, int l) {
        int across = columns[l];
        int row = (cell - firstCell[l]) / across;
        int column = cell - firstCell[l] - row * across;
        if (column == 0 || column >= across - 1 || row == 0 || row >= rows[l] - 1) {
            return false;
        }
        gather(0, start[cell - across - 1], start[cell - across + 2]);
        gather(0, start[cell - 1], start[cell + 2]);
        gather(0, start[cell + across - 1], start[cell + across + 2]);
        return true;
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
        } else if (keepsToCell(home[p], newX, newY, newReach)) {
            at[3 * p] = newX;
            at[3 * p + 1] = newY;
            at[3 * p + 2] = newReach;
        } else {
            home[p] = -1 - strays;
            at[3 * p + 2] = Double.NaN;
            growStrays();
            setStray(strays++, i, newX, newY, newReach);
            if (strays > FEW_STRAYS && (double) strays * strays > MOST_STRAYS * MOST_STRAYS * count) {
                sortAnew();
            }
        }
    }

    /** Whether a circle reaches no farther beyond a cell than one that is sorted there. */
    private boolean keepsToCell(int cell, double newX, double newY, double newReach) {
        int l = levelOf(cell);
        int row = (cell - firstCell[l]) / columns[l];
        int column = cell - firstCell[l] - row * columns[l];
        return keeps(column, columns[l], newX * columnsPerLength[l], newReach * columnsPerLength[l])
                && keeps(row, rows[l], newY * rowsPerLength[l], newReach * rowsPerLength[l]);
    }

    private int levelOf(int cell) {
        int k = levels - 1;
        while (firstCell[used[k]] > cell) {
            k--;
        }
        return used[k];
    }

    /** The same along one axis, in cells; on the torus every so-manieth row or column is the same. */
    private boolean keeps(int number, int of, double centre, double reached) {
        double whole = Math.floor(centre);
        int away = fold(whole, of) - number;
        away = 2 * away > of ? away - of : 2 * away < -of ? away + of : away;
        double inCell = centre - whole + away;
        return of == 1 || inCell - reached >= -OVERHANG && inCell + reached <= 1 + OVERHANG;
    }

    private void sortAnew() {
        for (int p = 0; p < count; p++) {
            x[circle[p]] = at[3 * p];
            y[circle[p]] = at[3 * p + 1];
            reach[circle[p]] = at[3 * p + 2];
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

package io.github.apsis.engine.spatial;

import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.parallel.Team;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * The search of one thread through the cells of a {@link CircleGrid}: for the pairs of a share of all circles, or around one.
 * Circles in neighbouring cells are gathered first and compared after, each in a loop whose branches can be foretold.
 */
final class CellSearch {
    private static final int AT_ONCE = 4096; // neighbours are compared before there are more
    private static final int AT_A_TIME = 64; // places

    private final CircleGrid grid;
    private final @Nullable Period period;

    private final int[] candidate = new int[AT_A_TIME]; // places that touch one ahead
    private final int[] other = new int[AT_A_TIME]; // places whose surroundings must be looked up
    private int others;
    private int neighbours;
    private long[] neighbour = new long[64]; // place << 32 | other place
    private int pairs;
    private int[] first = new int[64];
    private int[] second = new int[64];

    CellSearch(CircleGrid grid, @Nullable Period period) {
        this.grid = grid;
        this.period = period;
    }

    /** Finds the pairs of a share of all rows and circles, and forgets those of before. */
    void find(int share, int shares) {
        pairs = 0;
        for (int k = 0; k < grid.levels; k++) {
            pairWithin(grid.used[k], share, shares);
            for (int m = k + 1; m < grid.levels; m++) {
                pairAcross(grid.used[k], grid.used[m], share, shares);
            }
        }
    }

    /**
     * Pairs of one level: each circle with those behind it in its cell, with the cell to the right, and with three of the next row.
     * Most touch none of these; those that do are found first and paired after, in loops in which nothing is called and nothing
     * need be guessed.
     */
    private void pairWithin(int l, int share, int shares) {
        int end = place(l, share + 1, shares);
        for (int p = place(l, share, shares); p < end; p += AT_A_TIME) {
            int found = sift(l, p, Math.min(end, p + AT_A_TIME));
            pairAhead(l, found);
            for (int k = 0; k < others; k++) {
                gatherAhead(l, other[k]);
                compareWhenMany();
            }
            compare();
        }
    }

    /**
     * Lists the places that seem to touch one ahead. What is behind one in its row up to the next cell, and in three cells of the
     * next row, are two runs of places, most shorter than three: to compare with two and with three is faster than to look how long
     * they are. Places with longer runs, and those at the seam, are listed as others.
     */
    private int sift(int l, int from, int to) {
        int[] start = grid.start;
        int[] home = grid.home;
        double[] at = grid.at;
        int[] list = candidate;
        int[] otherList = other;
        int first = grid.firstCell[l];
        int across = grid.columns[l];
        int lastRow = first + (grid.rows[l] - 1) * across;
        int found = 0;
        int left = 0;
        for (int p = from; p < to; p++) {
            int cell = home[p];
            int column = cell - first & across - 1;
            otherList[left] = p;
            if (period != null || column == 0 || column == across - 1 || cell >= lastRow) {
                left++;
                continue;
            }
            int end = start[cell + 2];
            int next = start[cell + across - 1];
            int nextEnd = start[cell + across + 2];
            double px = at[3 * p];
            double py = at[3 * p + 1];
            double pr = at[3 * p + 2];
            long apart = apart(at, p + 1, px, py, pr)
                    & apart(at, p + 2, px, py, pr)
                    & apart(at, next, px, py, pr)
                    & apart(at, next + 1, px, py, pr)
                    & apart(at, next + 2, px, py, pr);
            int areShort = end - p - 4 & nextEnd - next - 4;
            list[found] = p;
            found += (int) (areShort >>> 31 & ~apart >>> 63);
            left += 1 + (areShort >> 31);
        }
        others = left;
        return found;
    }

    /** Makes pairs of the places that have been listed and of those ahead that they touch. */
    private void pairAhead(int l, int found) {
        makeRoom(5 * found);
        int[] start = grid.start;
        int[] home = grid.home;
        int[] circle = grid.circle;
        double[] at = grid.at;
        int[] list = candidate;
        int[] ones = first;
        int[] twos = second;
        int across = grid.columns[l];
        int k = pairs;
        for (int n = 0; n < found; n++) {
            int p = list[n];
            int cell = home[p];
            int end = start[cell + 2];
            int next = start[cell + across - 1];
            int nextEnd = start[cell + across + 2];
            double px = at[3 * p];
            double py = at[3 * p + 1];
            double pr = at[3 * p + 2];
            int own = circle[p];
            k += put(ones, twos, k, own, circle[p + 1], p + 1 - end, apart(at, p + 1, px, py, pr));
            k += put(ones, twos, k, own, circle[p + 2], p + 2 - end, apart(at, p + 2, px, py, pr));
            k += put(ones, twos, k, own, circle[next], next - nextEnd, apart(at, next, px, py, pr));
            k += put(ones, twos, k, own, circle[next + 1], next + 1 - nextEnd, apart(at, next + 1, px, py, pr));
            k += put(ones, twos, k, own, circle[next + 2], next + 2 - nextEnd, apart(at, next + 2, px, py, pr));
        }
        pairs = k;
    }

    /** Writes a pair; 1 if it stays, as it does when the other is before the end of its run and not apart. */
    private static int put(int[] first, int[] second, int k, int one, int other, int fromEnd, long apart) {
        first[k] = Math.min(one, other);
        second[k] = Math.max(one, other);
        return fromEnd >>> 31 & (int) (~apart >>> 63);
    }

    private void gatherAhead(int l, int p) {
        int across = grid.columns[l];
        int cell = grid.home[p];
        int row = grid.rowOf(cell, l);
        int here = grid.firstCell[l] + row * across;
        int column = cell - here;
        int next = row + 1 < grid.rows[l] ? here + across : grid.firstCell[l];
        gatherAtSeam(p, column, across, here, next);
    }

    /** Where a share of the circles of a level begins. */
    private int place(int l, int share, int shares) {
        return grid.start[grid.firstCell[l]] + Team.beginning(share, shares, grid.size[l]);
    }

    private void gatherAtSeam(int p, int column, int across, int here, int next) {
        gather(p, p + 1, grid.start[here + Math.min(across, column + 2)]);
        if (across > 1 && column == across - 1) {
            gather(p, grid.start[here], grid.start[here + 1]);
        }
        if (next != here) {
            gatherThree(p, column, across, next);
        }
    }

    /** The cell in this column of a row, and those beside it. */
    private void gatherThree(int p, int column, int across, int row) {
        gather(p, grid.start[row + Math.max(0, column - 1)], grid.start[row + Math.min(across, column + 2)]);
        if (across > 1 && column == 0) {
            gather(p, grid.start[row + across - 1], grid.start[row + across]);
        }
        if (across > 1 && column == across - 1) {
            gather(p, grid.start[row], grid.start[row + 1]);
        }
    }

    /** Negative when two do not touch: the sign of a difference, which is no branch. */
    private static long apart(double[] a, int q, double px, double py, double pr) {
        double dx = a[3 * q] - px;
        double dy = a[3 * q + 1] - py;
        double distance = a[3 * q + 2] + pr;
        return Double.doubleToRawLongBits(distance * distance - (dx * dx + dy * dy));
    }

    private void add(int p, int q) {
        makeRoom(1);
        first[pairs] = Math.min(grid.circle[p], grid.circle[q]);
        second[pairs++] = Math.max(grid.circle[p], grid.circle[q]);
    }

    private void makeRoom(int more) {
        if (pairs + more > first.length) {
            first = Arrays.copyOf(first, Math.max(pairs + more, 2 * first.length));
            second = Arrays.copyOf(second, first.length);
        }
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
        double[] at = grid.at;
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

    boolean touch(double dx, double dy, double distance) {
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
    private void pairAcross(int fine, int coarse, int share, int shares) {
        double runs = Math.min(grid.rows[fine], 2 + 1.5 * grid.side[coarse] / grid.side[fine]);
        boolean fromCoarse = grid.size[coarse] * runs < grid.size[fine] * 3.0;
        int from = fromCoarse ? coarse : fine;
        int to = fromCoarse ? fine : coarse;
        int end = place(from, share + 1, shares);
        for (int p = place(from, share, shares); p < end; p++) {
            gatherAround(p, to, grid.at[3 * p], grid.at[3 * p + 1], grid.at[3 * p + 2]);
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
    void gatherAround(int p, int l, double cx, double cy, double r) {
        double overhang = CircleGrid.OVERHANG + CircleGrid.MARGIN;
        double left = Math.floor((cx - r) * grid.columnsPerLength[l] - overhang);
        double right = Math.floor((cx + r) * grid.columnsPerLength[l] + overhang);
        double low = Math.floor((cy - r) * grid.rowsPerLength[l] - overhang);
        double high = Math.floor((cy + r) * grid.rowsPerLength[l] + overhang);
        int across = grid.columns[l];
        int from = 0;
        int to = across;
        if (right - left + 1 < across) {
            from = grid.fold(left, across);
            to = from + (int) (right - left) + 1;
        }
        int row = 0;
        int rowsLeft = grid.rows[l];
        if (high - low + 1 < rowsLeft) {
            row = grid.fold(low, rowsLeft);
            rowsLeft = (int) (high - low) + 1;
        }
        for (; rowsLeft > 0; rowsLeft--) {
            int here = grid.firstCell[l] + row * across;
            gather(p, grid.start[here + from], grid.start[here + Math.min(to, across)]);
            if (to > across) {
                gather(p, grid.start[here], grid.start[here + to - across]);
            }
            row = row + 1 < grid.rows[l] ? row + 1 : 0;
        }
    }

    /** Gathers a cell and the eight around it; false at the seam. */
    boolean gatherBeside(int cell, int l) {
        int[] start = grid.start;
        int across = grid.columns[l];
        int row = grid.rowOf(cell, l);
        int column = cell - grid.firstCell[l] - row * across;
        if (column == 0 || column >= across - 1 || row == 0 || row >= grid.rows[l] - 1) {
            return false;
        }
        gather(0, start[cell - across - 1], start[cell - across + 2]);
        gather(0, start[cell - 1], start[cell + 2]);
        gather(0, start[cell + across - 1], start[cell + across + 2]);
        return true;
    }

    /** How many circles have been gathered since the last were kept or compared. */
    int neighbours() {
        return neighbours;
    }

    /** Keeps those that touch a circle, and returns how many. */
    int keepTouching(double cx, double cy, double r, int[] found) {
        long[] list = neighbour;
        double[] at = grid.at;
        int[] circle = grid.circle;
        int hits = 0;
        for (int n = 0; n < neighbours; n++) {
            int q = (int) list[n];
            found[hits] = circle[q];
            hits += touch(at[3 * q] - cx, at[3 * q + 1] - cy, at[3 * q + 2] + r) ? 1 : 0;
        }
        neighbours = 0;
        return hits;
    }

    /** How many pairs have been found. */
    int pairs() {
        return pairs;
    }

    int first(int k) {
        return first[k];
    }

    int second(int k) {
        return second[k];
    }

    /** Puts the pairs that another search has found behind those of this. */
    void append(CellSearch other) {
        makeRoom(other.pairs);
        System.arraycopy(other.first, 0, first, pairs, other.pairs);
        System.arraycopy(other.second, 0, second, pairs, other.pairs);
        pairs += other.pairs;
    }
}

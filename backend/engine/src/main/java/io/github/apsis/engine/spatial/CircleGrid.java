package io.github.apsis.engine.spatial;

import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.parallel.Work;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Circles of any size and which of them touch: {@link #begin}, {@link #set} for every circle or all at once, {@link #build},
 * then {@link #findPairs}; and where some change later {@link #move}, and {@link #query} for what touches one.
 *
 * <p>A circle belongs to a grid whose cells are as wide as it is, or up to four times as wide, so it reaches half a cell beyond
 * its own at most and meets circles of its grid in the eight cells around alone; grids of other sizes are asked around it. Cells
 * are numbered row by row and circles sorted by their cells in one count (Knuth 1973, TAOCP 3, 5.2): three neighbours in a row
 * are one run of memory. A plane is folded up into a torus of two or three cells for each circle, or up to five, so what has flown
 * off costs nothing; circles that are neighbours only by the fold are told apart by their distance.
 *
 * <p>17 to 26 ns a circle, of 1000 and of 5000, for sorting and all pairs where all are of one size; up to one and a half that
 * where radii go from 1 to 100 with a density falling as r⁻³. Nothing is allocated once warm.
 */
public final class CircleGrid {
    private static final int LEVELS = 64;
    private static final int MIDDLE = 40; // the level of most circles
    private static final int TOP = LEVELS - 1; // one cell, for all that is larger

    /** Cells are so much wider than most circles: some grow when paths are bent. */
    private static final double ROOM = 1.22;

    /** Of a cell: what the numbers of rows and columns lose to rounding is less, see {@link #ROUNDING}. */
    static final double MARGIN = 0x1p-10;

    /** Of the coordinates, added to each circle: so a row or a column never has a number beyond 2³⁹. */
    private static final double ROUNDING = 0x1p-40;

    /** So far circles reach beyond their cells, in cells. */
    static final double OVERHANG = 0.5;

    private static final double SMALLEST = 0x1p-800;
    private static final double LARGEST = 0x1p900;

    private static final int SAMPLE = 64; // circles that tell the size of most
    private static final int KINDS = 256; // of sizes, by their exponents; what differs by 2^256 counts as alike
    private static final double MUCH_LARGER = 8; // times what is usual
    private static final double CELLS = 2.5; // for each circle, or up to twice as many
    private static final int FEWEST_COLUMNS = 4; // on a torus of two, a cell is its own neighbour's neighbour
    private static final int SHARES = 8; // of the circles, for a team
    private static final int MANY =
            4000; // circles, whose pairs take 50 µs: with fewer a team saves hardly more than it costs
    private static final int FEW_STRAYS = 32;
    private static final double MOST_STRAYS =
            4; // times the root of all: then sorting anew is cheaper than looking at each

    private final @Nullable Period period;
    private final Workspace workspace;

    private int count;
    private double[] x = new double[0]; // as they were set
    private double[] y = new double[0];
    private double[] reach = new double[0];
    private int[] place = new int[0]; // in the order of the cells; before it is known, level and cell

    private final byte[] sampled = new byte[KINDS]; // by the lower bits of exponents; there are no more than 127
    final int[] size = new int[LEVELS]; // circles of each level
    final int[] used = new int[LEVELS]; // the levels that have any, fine ones first
    int levels;
    private int cells;
    private double unit; // the side of cells in the middle level, length
    final double[] side = new double[LEVELS];
    final double[] columnsPerLength = new double[LEVELS];
    final double[] rowsPerLength = new double[LEVELS];
    final int[] columns = new int[LEVELS];
    final int[] rows = new int[LEVELS];
    final int[] firstCell = new int[LEVELS];
    int[] start = new int[0]; // by cell: the place of its first circle

    // By place.
    int[] circle = new int[0];
    int[] home = new int[0]; // its cell
    double[] at = new double[0]; // x, y, radius (NaN of a stray)

    // Circles that reach farther from their cells than when they were sorted.
    private int strays;
    private int[] stray = new int[FEW_STRAYS];
    private double[] strayX = new double[FEW_STRAYS];
    private double[] strayY = new double[FEW_STRAYS];
    private double[] strayReach = new double[FEW_STRAYS];

    private int[] found = new int[16];
    private final Team team;
    private final CellSearch[] search; // by share
    private final Work searching = this::searchShare;

    /** A grid over a plane, or over a world that repeats itself: there a circle meets the nearest image of another. */
    public CircleGrid(@Nullable Period period) {
        this(period, Team.ofOne(), new Workspace());
    }

    /**
     * The same, in the columns of a workspace, with which what was found is lost; the pairs of many circles are found by a
     * team.
     */
    public CircleGrid(@Nullable Period period, Team team, Workspace workspace) {
        this.period = period;
        this.team = team;
        this.workspace = workspace;
        this.search = new CellSearch[team.size() > 1 ? SHARES : 1];
        Arrays.setAll(search, share -> new CellSearch(this, period));
    }

    /** Forgets everything and makes room for so many circles. */
    public void begin(int circles) {
        count = circles;
        workspace.take(this);
        x = workspace.doubles(0, circles);
        y = workspace.doubles(1, circles);
        reach = workspace.doubles(2, circles);
        at = workspace.doubles(3, 3 * (circles + 3)); // a look at three goes beyond the last
        place = workspace.ints(0, circles);
        circle = workspace.ints(1, circles + 3);
        home = workspace.ints(2, circles);
    }

    /** One circle; all numbers finite. */
    public void set(int i, double centreX, double centreY, double radius) {
        x[i] = period == null ? centreX : period.insideX(centreX);
        y[i] = period == null ? centreY : period.insideY(centreY);
        reach[i] = withRounding(centreX, centreY, radius);
    }

    /** Where the centres of all circles can be written at once, as the radii; {@link #takeAll} then. */
    public double[] centresX() {
        return x;
    }

    public double[] centresY() {
        return y;
    }

    public double[] radii() {
        return reach;
    }

    /** All circles have been written, as if {@link #set} had been called for each. */
    public void takeAll() {
        addRounding(x, y, reach, count);
        if (period != null) {
            for (int i = 0; i < count; i++) {
                x[i] = period.insideX(x[i]);
                y[i] = period.insideY(y[i]);
            }
        }
    }

    private static void addRounding(double[] x, double[] y, double[] reach, int count) {
        for (int i = 0; i < count; i++) {
            reach[i] = withRounding(x[i], y[i], reach[i]);
        }
    }

    private static double withRounding(double centreX, double centreY, double radius) {
        return radius + ROUNDING * (radius + Math.abs(centreX) + Math.abs(centreY));
    }

    /** Sorts the circles. */
    public void build() {
        strays = 0;
        unit = 2 * ROOM * fittingReach();
        if (!sortAsOneLevel()) {
            chooseLevels();
            sort();
        }
    }

    /**
     * The reach that the cells are made for, from a sample: what is usual, or the root of the mean square where that is more, so
     * that as many circles share a cell whether their sizes differ or not. What is much larger counts as so large: it may be
     * elsewhere.
     */
    private double fittingReach() {
        int step = Math.max(1, count / SAMPLE);
        double usual = usualReach(step);
        double most = MUCH_LARGER * usual;
        double squares = 0;
        int sample = 0;
        for (int i = 0; i < count; i += step) {
            double counted = reach[i] < most ? reach[i] : most;
            squares += counted * counted;
            sample++;
        }
        double fitting = Math.max(usual, Math.sqrt(squares / Math.max(1, sample)));
        return Math.max(SMALLEST, Math.min(LARGEST, fitting));
    }

    /** The mean of a sample, without those that differ by more than their exponent from most. */
    private double usualReach(int step) {
        int most = 0;
        for (int i = 0; i < count; i += step) {
            int kind = kindOf(reach[i]);
            if (reach[i] > 0) {
                sampled[kind]++;
                most = sampled[kind] > sampled[most] ? kind : most;
            }
        }
        int alike = sampled[most];
        double sum = 0;
        for (int i = 0; i < count; i += step) {
            int kind = kindOf(reach[i]);
            sum += kind == most ? reach[i] : 0;
            sampled[kind] = 0;
        }
        return alike == 0 ? 1 : sum / alike;
    }

    private static int kindOf(double size) {
        return Math.getExponent(size) & KINDS - 1;
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

    /** Gives each level its cells, two and a half times as many as circles or more, all empty. */
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
        start = workspace.ints(3, cells + cells / 64 + 1); // a few more when sizes differ
        Arrays.fill(start, 0, cells + 1, 0);
    }

    private void fold(int l) {
        double wanted = CELLS * size[l];
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
        double shrink = Math.max(1, Math.sqrt(across * up / (CELLS * size[l] + FEWEST_COLUMNS * FEWEST_COLUMNS)));
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
    int fold(double number, int of) {
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
        requireColumns();
        if (search.length == 1 || count < MANY) {
            search[0].find(0, 1);
            return search[0].pairs();
        }
        team.share(searching, SHARES);
        for (int share = 1; share < SHARES; share++) {
            search[0].append(search[share]);
        }
        return search[0].pairs();
    }

    private void requireColumns() {
        if (!workspace.isHeldBy(this)) {
            throw new IllegalStateException("the circles are gone: another part has taken the workspace");
        }
    }

    private void searchShare(int share, int member) {
        search[share].find(share, SHARES);
    }

    /**
     * Finds the circles, as they are now, that touch this one, each once and itself among them; {@link #found} gives them, until
     * the next query.
     *
     * @return how many
     */
    public int query(int i) {
        requireColumns();
        int p = place[i];
        boolean isStray = home[p] < 0;
        double cx = isStray ? strayX[-1 - home[p]] : at[3 * p];
        double cy = isStray ? strayY[-1 - home[p]] : at[3 * p + 1];
        double r = isStray ? strayReach[-1 - home[p]] : at[3 * p + 2];
        int own = isStray ? -1 : levelOf(home[p]);
        CellSearch around = search[0];
        for (int k = 0; k < levels; k++) {
            if (used[k] != own || !around.gatherBeside(home[p], own)) {
                around.gatherAround(0, used[k], cx, cy, r);
            }
        }
        if (around.neighbours() + strays > found.length) {
            found = new int[Math.max(around.neighbours() + strays, 2 * found.length)];
        }
        int hits = around.keepTouching(cx, cy, r, found);
        for (int s = 0; s < strays; s++) {
            found[hits] = stray[s];
            hits += around.touch(strayX[s] - cx, strayY[s] - cy, strayReach[s] + r) ? 1 : 0;
        }
        return hits;
    }

    /** The {@code hit}-th circle of the last query. */
    public int found(int hit) {
        return found[hit];
    }

    /** The lower number of the {@code k}-th pair. */
    public int first(int k) {
        return search[0].first(k);
    }

    /** The higher number of the {@code k}-th pair. */
    public int second(int k) {
        return search[0].second(k);
    }

    /** Changes a circle after {@link #build}. */
    public void move(int i, double centreX, double centreY, double radius) {
        requireColumns();
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
        int row = rowOf(cell, l);
        int column = cell - firstCell[l] - row * columns[l];
        return keeps(column, columns[l], newX * columnsPerLength[l], newReach * columnsPerLength[l])
                && keeps(row, rows[l], newY * rowsPerLength[l], newReach * rowsPerLength[l]);
    }

    /** The row of a cell within its level; on the folded plane without a division. */
    int rowOf(int cell, int l) {
        int number = cell - firstCell[l];
        return period == null ? number >>> Integer.numberOfTrailingZeros(columns[l]) : number / columns[l];
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

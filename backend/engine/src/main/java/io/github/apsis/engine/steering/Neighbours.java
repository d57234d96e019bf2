package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.parallel.Work;
import io.github.apsis.engine.spatial.Workspace;
import java.util.Arrays;

/**
 * Who is near: a copy of where all bodies are at the start of a decision, sorted into square cells.
 *
 * <p>Cells are hashed (Teschner et al. 2003, VMV, "Optimized spatial hashing"), so a body may be anywhere; those of one row lie
 * side by side, so a search reads as many runs of memory as it touches rows. What is larger than a cell is in a list of its
 * own. A search finds bodies in a fixed order, and any number of threads may search at once.
 */
final class Neighbours {
    private static final double COARSE = 1.0 / 2; // of the reach
    private static final double FINE = 1.0 / 8;

    /** Bodies from which on cells are fine: with 250 their rows cost more than they spare, with 10 000 a search looks at half as many. */
    private static final int MANY = 1000;

    /** Bodies from which on a team sorts them: fewer take less than 50 µs. */
    private static final int MANY_FOR_A_TEAM = 4000;

    private static final int SHARES = 8;

    private static final int FEW = 32; // large ones, which every search looks at
    private static final int FEWEST_BUCKETS = 64; // more than a search has columns: it meets no cell twice
    private static final double MOST_CELLS = 1e15; // away from the origin: farther out all bodies share the last one

    private double cell = 1; // length
    private double perCell = 1;
    private int mask;
    private int count;
    private int small; // how many are in cells; the large ones stand behind them
    private double largestRadius; // of those in cells, as the next two
    private double largestRootMass;
    private double topSpeed;

    private final Workspace workspace;
    private final Team team;
    private final Work numbering = this::numberShare;
    private final Work copying = this::copyShare;
    private Bodies bodies = new Bodies(); // that are being sorted
    private int shares;
    private final double[] radiusOfShare = new double[SHARES]; // the largest, as below
    private final double[] massOfShare = new double[SHARES];
    private final double[] squaredSpeedOfShare = new double[SHARES];
    private int buckets;
    private int[] start = new int[0]; // by bucket + 1: where its positions begin
    private int[] bucket = new int[0]; // by slot

    // By position, the columns that a search reads for all bodies in turn.
    int[] item = new int[0]; // the slot, of a ship its complement
    double[] x = new double[0];
    double[] y = new double[0];
    double[] rootMass = new double[0]; // mass^(1/2)
    double[] motion = new double[0]; // vx, vy, and the radius

    Neighbours(Team team, Workspace workspace) {
        this.team = team;
        this.workspace = workspace;
    }

    /** Sorts all bodies, for searches of about this reach, length. */
    void sort(Bodies of, double reach) {
        bodies = of;
        count = bodies.count();
        cell = reach * (isWorthFineCells(bodies, reach) ? FINE : COARSE);
        perCell = 1 / cell;
        makeRoom();
        shares = count < MANY_FOR_A_TEAM ? 1 : SHARES;
        team.share(numbering, shares);
        double largestMass = 0;
        double topSquared = 0;
        largestRadius = 0;
        for (int share = 0; share < shares; share++) {
            largestRadius = Math.max(largestRadius, radiusOfShare[share]);
            largestMass = Math.max(largestMass, massOfShare[share]);
            topSquared = Math.max(topSquared, squaredSpeedOfShare[share]);
        }
        largestRootMass = Math.sqrt(largestMass);
        topSpeed = Math.sqrt(topSquared);
        order();
        team.share(copying, shares);
    }

    /** Finds the buckets of a share of the bodies. */
    private void numberShare(int share, int member) {
        double topRadius = 0;
        double topMass = 0;
        double topSquared = 0;
        for (int i = beginningOf(share); i < beginningOf(share + 1); i++) {
            double r = bodies.radius(i);
            if (r > cell) {
                bucket[i] = -1;
            } else {
                bucket[i] = bucketOf(cellOf(bodies.x(i)), cellOf(bodies.y(i)));
                double squared = bodies.vx(i) * bodies.vx(i) + bodies.vy(i) * bodies.vy(i);
                topRadius = r > topRadius ? r : topRadius; // Math.max would wait for the one before
                topMass = bodies.mass(i) > topMass ? bodies.mass(i) : topMass;
                topSquared = squared > topSquared ? squared : topSquared;
            }
        }
        radiusOfShare[share] = topRadius;
        massOfShare[share] = topMass;
        squaredSpeedOfShare[share] = topSquared;
    }

    private int beginningOf(int share) {
        return Team.beginning(share, shares, count);
    }

    /** Gives every body a position, in the order of buckets. */
    private void order() {
        small = 0;
        for (int i = 0; i < count; i++) {
            if (bucket[i] >= 0) {
                start[bucket[i] + 1]++;
                small++;
            }
        }
        for (int b = 1; b < buckets + 2; b++) {
            start[b] += start[b - 1];
        }
        int last = count;
        for (int i = count - 1; i >= 0; i--) { // from behind: what was the end of a bucket becomes its begin
            item[bucket[i] >= 0 ? --start[bucket[i] + 1] : --last] = i;
        }
    }

    /** Copies what a search reads, for a share of the positions. */
    private void copyShare(int share, int member) {
        for (int p = beginningOf(share); p < beginningOf(share + 1); p++) {
            int i = item[p];
            x[p] = bodies.x(i);
            y[p] = bodies.y(i);
            rootMass[p] = Math.sqrt(bodies.mass(i));
            motion[3 * p] = bodies.vx(i);
            motion[3 * p + 1] = bodies.vy(i);
            motion[3 * p + 2] = bodies.radius(i);
            item[p] = bodies.isShip(i) ? ~i : i;
        }
    }

    private static boolean isWorthFineCells(Bodies bodies, double reach) {
        if (bodies.count() < MANY) {
            return false;
        }
        int large = 0;
        for (int i = 0; i < bodies.count(); i++) {
            if (bodies.radius(i) > FINE * reach) {
                large++;
            }
        }
        return large <= FEW;
    }

    private void makeRoom() {
        buckets = Math.max(FEWEST_BUCKETS, 2 * Integer.highestOneBit(Math.max(1, count)));
        mask = buckets - 1;
        workspace.take(this);
        item = workspace.ints(0, count);
        bucket = workspace.ints(1, count);
        start = workspace.ints(3, buckets + 2); // the longest column: the cells of contacts are there as well
        Arrays.fill(start, 0, buckets + 2, 0);
        x = workspace.doubles(0, count);
        y = workspace.doubles(1, count);
        rootMass = workspace.doubles(2, count);
        motion = workspace.doubles(3, 3 * (count + 3));
    }

    private long cellOf(double coordinate) {
        double cells = coordinate * perCell;
        return (long) Math.floor(Math.abs(cells) < MOST_CELLS ? cells : Math.copySign(MOST_CELLS, cells));
    }

    private int bucketOf(long column, long line) {
        return (int) (line * 0x9E3779B97F4A7C15L >>> 20) + (int) column & mask;
    }

    /**
     * Offers a search every body that may be urgent enough for it, and some that are not: row by row from the nearest on, for what
     * is near leaves little to take in of the rest.
     */
    void search(double px, double py, Nearest of) {
        for (int from = small; from < count; from += Nearest.AT_ONCE) {
            int large = of.sift(this, from, Math.min(count, from + Nearest.AT_ONCE));
            for (int f = 0; f < large; f++) {
                of.offer(this, of.found(f));
            }
        }
        long own = cellOf(py);
        double far = of.farthest(largestRadius, largestRootMass, topSpeed);
        searchRow(px, far, own, of);
        for (long away = 1; own - away >= cellOf(py - far) || own + away <= cellOf(py + far); away++) {
            searchRow(px, halfChord(far, py - cell * (own - away + 1)), own - away, of);
            searchRow(px, halfChord(far, cell * (own + away) - py), own + away, of);
            far = of.farthest(largestRadius, largestRootMass, topSpeed);
        }
    }

    /** Half the width of a circle at a distance from its centre, below 0 outside. */
    private static double halfChord(double radius, double distance) {
        return distance > radius ? -1 : Math.sqrt(radius * radius - distance * distance);
    }

    private void searchRow(double px, double halfWidth, long line, Nearest of) {
        if (halfWidth < 0) {
            return;
        }
        long fromColumn = cellOf(px - halfWidth);
        int columns = (int) Math.min(mask, cellOf(px + halfWidth) - fromColumn);
        int from = bucketOf(fromColumn, line);
        int to = from + columns;
        offer(start[from + 1], start[Math.min(to, mask) + 2], line, of);
        if (to > mask) { // the row goes on at the begin of the table
            offer(start[1], start[to - mask + 1], line, of);
        }
    }

    private void offer(int from, int to, long line, Nearest of) {
        for (int next = from; next < to; next += Nearest.AT_ONCE) {
            int found = of.sift(this, next, Math.min(to, next + Nearest.AT_ONCE));
            for (int f = 0; f < found; f++) {
                int p = of.found(f);
                if (cellOf(y[p]) == line) { // others have the same hash
                    of.offer(this, p);
                }
            }
        }
    }

    /** Of the body at a position. */
    int slot(int p) {
        return item[p] < 0 ? ~item[p] : item[p];
    }
}

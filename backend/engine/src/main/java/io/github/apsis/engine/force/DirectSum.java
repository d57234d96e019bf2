package io.github.apsis.engine.force;

import static java.lang.Math.fma;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.parallel.Work;
import io.github.apsis.engine.spatial.Workspace;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * The pulls of all masses on all, tile by tile of targets.
 *
 * <p>The loop over the targets of a tile has no branch and no sum across it, so that C2 makes vector code of it. What limits
 * it are root and quotient: two sources at a time share one division, 1/p and 1/q being q/(pq) and p/(pq). That is 2.6
 * interactions a nanosecond on JDK 17 and 25 alike (AVX-512), where one source at a time does 2.1. Every pair is worked out
 * twice, once from either end: once for both ends does 3.0 beyond some thousand bodies and less below, and its ends write to
 * each other's tiles. Four sources to a division are too long a loop for C2, and take seven times as long.
 *
 * <p>Every operation is a single IEEE one in a fixed order: neither the width of vectors nor the number of threads changes a
 * bit.
 */
final class DirectSum implements Work {
    /** Bodies from which on a team is asked: half of 0.2 ms is more than it takes to wake. */
    private static final int MANY = 700;

    private static final int TARGETS = 256; // a piece of work, in the first cache

    /**
     * Sources between two additions to the whole sum, a part of {@link #TARGETS}: with 512 the worst of 3000 bodies, whose pulls
     * all but cancel, was wrong by 1.1e-13, with 128 by 6e-14, and no slower.
     */
    private static final int SOURCES = 128;

    /** Length². Keeps 1/(d³ d³) finite where both d are 0, and is below the rounding of d² where coordinates are ordinary. */
    private static final double FLOOR = 1e-100;

    private static final double SMALLEST = 1e-26; // length; ordinary numbers beyond it differ by 1e-42 or not at all
    private static final double LARGEST = 1e49; // d³ d³ is a number below

    private final double g; // length³ / (mass · time²)
    private final double softeningSquared; // length²
    private final Team team;
    private final Team alone = Team.ofOne();
    private final Workspace workspace;
    private final PointMasses masses;
    private final Pulls[] pulls; // by member of the team
    private double[] sumX = new double[0]; // the part from one tile of sources
    private double[] sumY = new double[0];
    private boolean[] ordinary = new boolean[0]; // by tile of targets
    private @Nullable Bodies bodies; // while at work

    DirectSum(double g, double softening, Team team, Workspace workspace) {
        this.g = g;
        this.softeningSquared = softening * softening;
        this.team = team;
        this.workspace = workspace;
        this.masses = new PointMasses(workspace);
        this.pulls = new Pulls[team.size()];
        Arrays.setAll(pulls, member -> new Pulls());
    }

    /** Adds the pull on every body to its acceleration. */
    void apply(Bodies pulled) {
        int count = pulled.count();
        workspace.take(this);
        masses.begin(count);
        masses.load(pulled, 0, count);
        sumX = workspace.doubles(3, count);
        sumY = workspace.doubles(4, count);
        if (ordinary.length < tiles(count, TARGETS)) {
            ordinary = new boolean[tiles(sumX.length, TARGETS)];
        }
        for (int start = 0; start < count; start += TARGETS) {
            ordinary[start / TARGETS] = masses.liesBetween(SMALLEST, LARGEST, start, Math.min(start + TARGETS, count));
        }
        bodies = pulled;
        Team workers = count < MANY ? alone : team;
        workers.share(this, tiles(count, TARGETS));
        bodies = null;
    }

    private static int tiles(int count, int size) {
        return (count + size - 1) / size;
    }

    /** Works out the pull on one tile of targets. */
    @Override
    public void doPiece(int piece, int member) {
        int start = piece * TARGETS;
        int stop = Math.min(start + TARGETS, masses.count());
        Pulls pull = pulls[member];
        pull.begin(start, stop);
        for (int first = 0; first < masses.count(); first += SOURCES) {
            Arrays.fill(sumX, start, stop, 0);
            Arrays.fill(sumY, start, stop, 0);
            int end = Math.min(first + SOURCES, masses.count());
            // A body does not pull itself, as no body pulls another on the same spot.
            if (ordinary[first / TARGETS] && ordinary[start / TARGETS]) {
                pullByTile(start, stop, first, end);
            } else {
                pullByTileWithCare(start, stop, first, end);
            }
            pull.addAll(sumX, sumY, start, stop);
        }
        for (int i = start; bodies != null && i < stop; i++) {
            bodies.accelerate(i, g * pull.x(i), g * pull.y(i));
        }
    }

    private void pullByTile(int start, int stop, int first, int end) {
        double e2 = Math.max(softeningSquared, FLOOR);
        double[] x = masses.x;
        double[] y = masses.y;
        double[] mass = masses.mass;
        int i = first;
        for (; i < end - 1; i += 2) {
            pullByTwo(x, y, sumX, sumY, start, stop, x[i], y[i], mass[i], x[i + 1], y[i + 1], mass[i + 1], e2);
        }
        if (i < end) {
            pullByOne(x, y, sumX, sumY, start, stop, x[i], y[i], mass[i], e2);
        }
    }

    private static void pullByTwo(
            double[] x,
            double[] y,
            double[] sumX,
            double[] sumY,
            int start,
            int stop,
            double oneX,
            double oneY,
            double oneMass,
            double otherX,
            double otherY,
            double otherMass,
            double e2) {
        for (int j = start; j < stop; j++) {
            double dx = oneX - x[j];
            double dy = oneY - y[j];
            double d2 = fma(dx, dx, fma(dy, dy, e2));
            double d3 = d2 * Math.sqrt(d2);
            double ex = otherX - x[j];
            double ey = otherY - y[j];
            double f2 = fma(ex, ex, fma(ey, ey, e2));
            double f3 = f2 * Math.sqrt(f2);
            double w = 1 / (d3 * f3);
            double one = oneMass * (f3 * w);
            double other = otherMass * (d3 * w);
            sumX[j] = fma(one, dx, fma(other, ex, sumX[j]));
            sumY[j] = fma(one, dy, fma(other, ey, sumY[j]));
        }
    }

    private static void pullByOne(
            double[] x,
            double[] y,
            double[] sumX,
            double[] sumY,
            int start,
            int stop,
            double sourceX,
            double sourceY,
            double sourceMass,
            double e2) {
        for (int j = start; j < stop; j++) {
            double dx = sourceX - x[j];
            double dy = sourceY - y[j];
            double d2 = fma(dx, dx, fma(dy, dy, e2));
            double w = sourceMass / (d2 * Math.sqrt(d2));
            sumX[j] = fma(w, dx, sumX[j]);
            sumY[j] = fma(w, dy, sumY[j]);
        }
    }

    /** The same, without pairs whose distance has no cube: coincident, where a pull has no direction, or beyond 1e102. */
    private void pullByTileWithCare(int start, int stop, int first, int end) {
        for (int i = first; i < end; i++) {
            for (int j = start; j < stop; j++) {
                double dx = masses.x[i] - masses.x[j];
                double dy = masses.y[i] - masses.y[j];
                double d2 = fma(dx, dx, fma(dy, dy, softeningSquared));
                double d3 = d2 * Math.sqrt(d2);
                if (d3 >= Double.MIN_NORMAL && d3 <= Double.MAX_VALUE) {
                    double w = 1 / d3;
                    sumX[j] = fma(masses.mass[i], w * dx, sumX[j]);
                    sumY[j] = fma(masses.mass[i], w * dy, sumY[j]);
                }
            }
        }
    }
}

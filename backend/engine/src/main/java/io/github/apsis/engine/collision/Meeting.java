package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import org.jspecify.annotations.Nullable;

/**
 * Where the paths of two bodies lead, seen from the first: when they meet, and how far apart they end. In a periodic world
 * every image of the second that the path sweeps may be the one that is met, however many periods a tick spans.
 */
final class Meeting {
    private static final long MOST_PERIODS =
            300_000; // that a path may span in a tick: a million radii, and the smallest world is four wide

    private static final double BEYOND = 1 + 1e-12; // squares and their roots may round to either side

    private final Paths paths;
    private final @Nullable Period period;
    private final ContactMode mode;
    private int one;
    private int other;

    // The separation from t0, when both paths have begun, to the end of the tick.
    private double t0;
    private double d0x;
    private double d0y;
    private double d1x;
    private double d1y;

    private double bx; // relative acceleration
    private double by;

    private double earliest;

    Meeting(Paths paths, @Nullable Period period, ContactMode mode) {
        this.paths = paths;
        this.period = period;
        this.mode = mode;
    }

    /** Fills in the separation of two bodies on their present paths. */
    void of(Bodies bodies, int a, int b) {
        one = a;
        other = b;
        t0 = Math.max(paths.startTime(a), paths.startTime(b));
        d0x = paths.xAt(bodies, b, t0) - paths.xAt(bodies, a, t0);
        d0y = paths.yAt(bodies, b, t0) - paths.yAt(bodies, a, t0);
        d1x = bodies.x(b) - bodies.x(a);
        d1y = bodies.y(b) - bodies.y(a);
    }

    private void accelerate(Bodies bodies) {
        bx = Paths.accelerationX(bodies, other) - Paths.accelerationX(bodies, one);
        by = Paths.accelerationY(bodies, other) - Paths.accelerationY(bodies, one);
    }

    /** Whether there is a touch at all; not in a periodic world. */
    boolean touches(Bodies bodies, double sumOfRadii) {
        double outside = d0x * d0x + d0y * d0y - sumOfRadii * sumOfRadii;
        return outside <= 0
                ? approach(bodies, d0x, d0y)
                : !Double.isNaN(TimeOfImpact.onChord(d0x, d0y, d1x - d0x, d1y - d0y, outside, sumOfRadii));
    }

    /** The time of the first touch, NaN for none. */
    double time(Bodies bodies, double sumOfRadii) {
        if (period == null) {
            return time(bodies, 0, 0, sumOfRadii);
        }
        accelerate(bodies);
        earliest = Double.NaN;
        double bulge = (Math.abs(bx) + Math.abs(by)) * (paths.dt() - t0) * (paths.dt() - t0) / 8;
        double reach = sumOfRadii + bulge;
        long first = Math.round(Math.ceil((Math.min(d0x, d1x) - reach) / period.width()));
        long last = Math.round(Math.floor((Math.max(d0x, d1x) + reach) / period.width()));
        boolean forwards = d1x >= d0x;
        for (long n = 0; n <= Math.min(last - first, MOST_PERIODS); n++) {
            searchColumn(bodies, (forwards ? first + n : last - n) * period.width(), reach, sumOfRadii);
            if (n > 1 && !Double.isNaN(earliest)) {
                break; // columns are met one after the other; those that overlap in time are neighbours
            }
        }
        return earliest;
    }

    /** Looks at the images in one column that the separation passes while it is within reach of the column. */
    private void searchColumn(Bodies bodies, double shiftX, double reach, double sumOfRadii) {
        double wx = d1x - d0x;
        double enter = wx == 0 ? 0 : Math.min(1, Math.max(0, (shiftX - Math.copySign(reach, wx) - d0x) / wx));
        double leave = wx == 0 ? 1 : Math.min(1, Math.max(0, (shiftX + Math.copySign(reach, wx) - d0x) / wx));
        double from = d0y + (d1y - d0y) * enter;
        double to = d0y + (d1y - d0y) * leave;
        double height = requirePeriod().height();
        long first = Math.round(Math.ceil((Math.min(from, to) - reach) / height));
        long last = Math.round(Math.floor((Math.max(from, to) + reach) / height));
        boolean forwards = to >= from;
        for (long n = 0; n <= Math.min(last - first, MOST_PERIODS); n++) {
            double t = time(bodies, shiftX, (forwards ? first + n : last - n) * height, sumOfRadii);
            if (t < earliest || Double.isNaN(earliest)) {
                earliest = t;
            }
            if (n > 1 && !Double.isNaN(earliest)) {
                return;
            }
        }
    }

    private Period requirePeriod() {
        if (period == null) {
            throw new IllegalStateException("no period");
        }
        return period;
    }

    private double time(Bodies bodies, double shiftX, double shiftY, double sumOfRadii) {
        double fromX = d0x - shiftX;
        double fromY = d0y - shiftY;
        double toX = d1x - shiftX;
        double toY = d1y - shiftY;
        if (mode == ContactMode.EXACT) {
            accelerate(bodies);
            if (bx != 0 || by != 0) {
                return FirstTouch.ofCircles(fromX, fromY, toX, toY, bx, by, t0, paths.dt(), sumOfRadii);
            }
        }
        double outside = fromX * fromX + fromY * fromY - sumOfRadii * sumOfRadii;
        if (outside <= 0) {
            return approach(bodies, fromX, fromY) ? t0 : Double.NaN;
        }
        double share = TimeOfImpact.onChord(fromX, fromY, toX - fromX, toY - fromY, outside, sumOfRadii);
        if (Double.isNaN(share)) {
            return Double.NaN; // before anything is asked for that those who miss do not need
        }
        accelerate(bodies);
        return TimeOfImpact.onParabola(
                share, fromX, fromY, toX - fromX, toY - fromY, bx, by, t0, paths.dt(), sumOfRadii);
    }

    /** How fast the rims close at a time when they touch, length / time, or NaN at the very end of a tick; not in a periodic world. */
    double closingSpeed(Bodies bodies, double t, double sumOfRadii) {
        accelerate(bodies);
        double share = (t - t0) / (paths.dt() - t0);
        double bend = 0.5 * (t - t0) * (paths.dt() - t);
        double dx = d0x + (d1x - d0x) * share - bx * bend;
        double dy = d0y + (d1y - d0y) * share - by * bend;
        double since = t - 0.5 * paths.dt();
        double vx = bodies.vx(other) - bodies.vx(one) + bx * since;
        double vy = bodies.vy(other) - bodies.vy(one) + by * since;
        return -(dx * vx + dy * vy) / sumOfRadii;
    }

    /** Whether circles that touch already come closer. At the end of a tick no path is left, so velocities decide. */
    private boolean approach(Bodies bodies, double dx, double dy) {
        double vx = paths.vxAt(bodies, other, t0) - paths.vxAt(bodies, one, t0);
        double vy = paths.vyAt(bodies, other, t0) - paths.vyAt(bodies, one, t0);
        return dx * vx + dy * vy < 0 || (dx == 0 && dy == 0);
    }

    /** Whether the centres end farther apart than this, of images the nearest. */
    boolean endsBeyond(double distance) {
        return isBeyond(
                period == null ? d1x : period.nearestX(d1x), period == null ? d1y : period.nearestY(d1y), distance);
    }

    static boolean isBeyond(double dx, double dy, double distance) {
        return dx * dx + dy * dy > distance * distance * BEYOND;
    }

    /** How far apart the centres end, of images the nearest. */
    double lastDistance() {
        double dx = period == null ? d1x : period.nearestX(d1x);
        double dy = period == null ? d1y : period.nearestY(d1y);
        return Math.sqrt(dx * dx + dy * dy);
    }
}

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

    private final Paths paths;
    private final @Nullable Period period;
    private final ContactMode mode;

    // The separation from t0, when both paths have begun, to the end of the tick.
    private double t0;
    private double d0x;
    private double d0y;
    private double d1x;
    private double d1y;
    private double v0x; // at t0, length / time
    private double v0y;
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
        t0 = Math.max(paths.startTime(a), paths.startTime(b));
        d0x = paths.xAt(bodies, b, t0) - paths.xAt(bodies, a, t0);
        d0y = paths.yAt(bodies, b, t0) - paths.yAt(bodies, a, t0);
        d1x = bodies.x(b) - bodies.x(a);
        d1y = bodies.y(b) - bodies.y(a);
        v0x = paths.vxAt(bodies, b, t0) - paths.vxAt(bodies, a, t0);
        v0y = paths.vyAt(bodies, b, t0) - paths.vyAt(bodies, a, t0);
        bx = Paths.accelerationX(bodies, b) - Paths.accelerationX(bodies, a);
        by = Paths.accelerationY(bodies, b) - Paths.accelerationY(bodies, a);
    }

    /** The time of the first touch, NaN for none. */
    double time(double sumOfRadii) {
        if (period == null) {
            return time(0, 0, sumOfRadii);
        }
        earliest = Double.NaN;
        double bulge = (Math.abs(bx) + Math.abs(by)) * (paths.dt() - t0) * (paths.dt() - t0) / 8;
        double reach = sumOfRadii + bulge;
        long first = Math.round(Math.ceil((Math.min(d0x, d1x) - reach) / period.width()));
        long last = Math.round(Math.floor((Math.max(d0x, d1x) + reach) / period.width()));
        boolean forwards = d1x >= d0x;
        for (long n = 0; n <= Math.min(last - first, MOST_PERIODS); n++) {
            searchColumn((forwards ? first + n : last - n) * period.width(), reach, sumOfRadii);
            if (n > 1 && !Double.isNaN(earliest)) {
                break; // columns are met one after the other; those that overlap in time are neighbours
            }
        }
        return earliest;
    }

    /** Looks at the images in one column that the separation passes while it is within reach of the column. */
    private void searchColumn(double shiftX, double reach, double sumOfRadii) {
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
            double t = time(shiftX, (forwards ? first + n : last - n) * height, sumOfRadii);
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

    private double time(double shiftX, double shiftY, double sumOfRadii) {
        if (mode == ContactMode.EXACT && (bx != 0 || by != 0)) {
            return FirstTouch.ofCircles(
                    d0x - shiftX, d0y - shiftY, d1x - shiftX, d1y - shiftY, bx, by, t0, paths.dt(), sumOfRadii);
        }
        return TimeOfImpact.ofCircles(
                d0x - shiftX, d0y - shiftY, d1x - shiftX, d1y - shiftY, v0x, v0y, bx, by, t0, paths.dt(), sumOfRadii);
    }

    /** How far apart the centres end, of images the nearest. */
    double lastDistance() {
        double dx = period == null ? d1x : period.nearestX(d1x);
        double dy = period == null ? d1y : period.nearestY(d1y);
        return Math.sqrt(dx * dx + dy * dy);
    }
}

package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Aabb;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * How dangerous a course is: the sum over neighbours and walls of the worst that happens with each.
 *
 * <pre>
 *   need(t) = margin · (0.7 + 0.3 t/H)        left = (1 − t/H)²
 *   too close: 4 (c + left) (need − gap) / margin        touching: + 4 (0.15 + left) (1 + 8 depth / margin)
 *   overlapping, or nearly: + 100 (1 − t/0.6H)² until 0.6 H
 * </pre>
 *
 * <p>c is 0.02, and 0.2 against ships. The depth tells a graze from a blow: without it a ship in a jam, where every course touches
 * somebody, flew straight into one that crossed. Parting early from ships and counting depth took circles of 200 from 6 meetings in 30
 * seeds to 2 in the same. A real overlap outweighs all else that a course may cost: ships in a jam then break away while they can. That
 * took circles of 200 from 14 meetings in 200 seeds to none, and one in 200 others.
 *
 * <p>Where two are closer already than they should be, need starts from there and grows: what counts is to get apart. The worst of
 * all neighbours instead of the sum hides the second threat behind the first.
 */
final class Risk {
    private static final double NEED_NOW = 0.7; // of the margin
    private static final double CLOSE = 4;
    private static final double CLOSE_LATE = 0.02;
    private static final double CLOSE_LATE_SHIP = 0.2; // ships part early, while they still have a choice
    private static final double TOUCH = 4;
    private static final double TOUCH_LATE = 0.15;
    private static final double BEYOND = 0.03; // the same after the horizon: enough to leave a gap that closes slowly
    private static final double DEEPER = 8; // times more per margin of overlap: of two evils the graze
    private static final double ALMOST = 0.2; // of the margin: closer counts as touching
    private static final double GRAZE = 0.08; // of the full margin: closer counts as an overlap
    private static final double OVERLAP = 100; // soon, more than all else together
    private static final double OVERLAP_WITHIN = 0.6; // of the horizon: later ships may have changed their minds
    private static final double APART = 3; // margins per horizon in which to part
    private static final double AT_ONCE = 0.05; // margins: two that touch must part, and not merely stay
    private static final double STRAIGHT = 1e-6; // radians
    private static final double WALL = 0.3; // of the margin: a wall stands still

    private final Forecast forecast;
    private final @Nullable Aabb walls;

    private double vx; // of the ship
    private double vy;
    private double horizon; // time
    private double fullMargin; // length
    private double restX; // where a course towards it ends, relative to where the ship is; 0 when nowhere
    private double restY;
    private boolean nearWall;
    private double wallGap; // now, length
    private double left; // where the centre may be, relative to where it is
    private double right;
    private double bottom;
    private double top;

    private final double[] pathX = new double[Forecast.COUNT + 1]; // from where it is
    private final double[] pathY = new double[Forecast.COUNT + 1];
    private final int[] close = new int[Nearest.MOST];
    private final double[] cost = new double[Nearest.MOST];
    private int worst;
    private double worstCost;
    private double worstTime;

    Risk(Forecast forecast, @Nullable Aabb walls) {
        this.forecast = forecast;
        this.walls = walls;
    }

    /** Prepares for the ship in slot {@code i}, whose neighbours are in the forecast. */
    void begin(Bodies bodies, int i, double range, double until, double margin) {
        vx = bodies.vx(i);
        vy = bodies.vy(i);
        horizon = until;
        fullMargin = margin;
        restX = 0;
        restY = 0;
        nearWall = false;
        if (walls != null) {
            double r = bodies.radius(i);
            left = walls.minX() + r - bodies.x(i);
            right = walls.maxX() - r - bodies.x(i);
            bottom = walls.minY() + r - bodies.y(i);
            top = walls.maxY() - r - bodies.y(i);
            wallGap = wallGap(0, 0);
            nearWall = wallGap < range;
        }
    }

    /** From now on a course straight towards this place is taken to end there. */
    void restAt(double x, double y) {
        restX = x;
        restY = y;
    }

    /** Whether there is anything to run into. */
    boolean isAnythingNear() {
        return nearWall || forecast.count() > 0;
    }

    private double wallGap(double x, double y) {
        return Math.min(Math.min(x - left, right - x), Math.min(y - bottom, top - y));
    }

    /**
     * The risk of a course.
     *
     * @param a what the ship can accelerate in that direction
     * @param lag of its response, time
     * @param bound beyond which the exact value does not matter
     */
    double of(double wx, double wy, double a, double lag, double bound) {
        follow(wx, wy, a, lag);
        worst = -1;
        worstCost = 0;
        double risk = nearWall ? ofWalls() : 0;
        Arrays.fill(cost, 0, forecast.count(), 0);
        for (int k = 0; k < Forecast.COUNT && risk < bound; k++) {
            risk += until(k);
        }
        return risk;
    }

    private void follow(double wx, double wy, double a, double lag) {
        double dx = wx - vx;
        double dy = wy - vy;
        double duration = Manoeuvre.duration(Math.sqrt(dx * dx + dy * dy), a, lag);
        for (int k = 0; k < Forecast.COUNT; k++) {
            pathX[k + 1] = Manoeuvre.at(forecast.time(k), vx, wx, duration);
            pathY[k + 1] = Manoeuvre.at(forecast.time(k), vy, wy, duration);
        }
        double towards = wx * restX + wy * restY;
        if (towards > 0 && Math.abs(wx * restY - wy * restX) <= STRAIGHT * towards) {
            endPath(restX * restX + restY * restY);
        }
    }

    private void endPath(double distanceSquared) {
        for (int k = 1; k < pathX.length; k++) {
            double d2 = pathX[k] * pathX[k] + pathY[k] * pathY[k];
            if (d2 > distanceSquared) {
                double cut = Math.sqrt(distanceSquared / d2);
                pathX[k] *= cut;
                pathY[k] *= cut;
            }
        }
    }

    private double ofWalls() {
        double most = 0;
        for (int k = 0; k < Forecast.WITHIN_HORIZON; k++) {
            double gap = wallGap(pathX[k + 1], pathY[k + 1]);
            if (gap < WALL * fullMargin) {
                most = Math.max(most, severity(gap, forecast.time(k), WALL * fullMargin, wallGap, CLOSE_LATE));
            }
        }
        return most;
    }

    /** What the stretch before the {@code k}-th time adds, all relative motion in it being straight. */
    private double until(int k) {
        int n = sift(k);
        double added = 0;
        for (int c = 0; c < n; c++) {
            if (k < Forecast.WITHIN_HORIZON || !forecast.isShip(close[c])) {
                added += pass(close[c], k);
            }
        }
        return added;
    }

    /**
     * Collects who is closer in this stretch than it should be. There is no branch in it: one that is as good as random takes as long
     * as two neighbours do.
     */
    private int sift(int k) {
        double[] fromX = forecast.fromX(k);
        double[] fromY = forecast.fromY(k);
        double[] toX = forecast.toX(k);
        double[] toY = forecast.toY(k);
        double[] keepOut = forecast.keepOut();
        double beginX = pathX[k];
        double beginY = pathY[k];
        double endX = pathX[k + 1];
        double endY = pathY[k + 1];
        int within = forecast.within(k);
        int n = 0;
        for (int m = 0; m < within; m++) {
            double x = fromX[m] - beginX;
            double y = fromY[m] - beginY;
            double dx = toX[m] - endX - x;
            double dy = toY[m] - endY - y;
            double before = x * x + y * y - keepOut[m] * keepOut[m];
            double towards = -(x * dx + y * dy);
            double d2 = dx * dx + dy * dy;
            double after = before + d2 - 2 * towards;
            // Whether (distance of the line)² < (distance to keep)² between the ends, without the division.
            long passes = sign(before * d2 - towards * towards) & sign(-towards) & sign(towards - d2);
            close[n] = m;
            n -= (int) ((sign(before) | sign(after) | passes) >> 63);
        }
        return n;
    }

    /** A number that is negative where the value is, and where it is −0. */
    private static long sign(double value) {
        return Double.doubleToRawLongBits(value);
    }

    private double pass(int m, int k) {
        double x = forecast.fromX(k)[m] - pathX[k];
        double y = forecast.fromY(k)[m] - pathY[k];
        double dx = forecast.toX(k)[m] - pathX[k + 1] - x;
        double dy = forecast.toY(k)[m] - pathY[k + 1] - y;
        double towards = -(x * dx + y * dy);
        double d2 = dx * dx + dy * dy;
        double share = towards <= 0 ? 0 : towards >= d2 ? 1 : towards / d2;
        double nearX = x + share * dx;
        double nearY = y + share * dy;
        double gap = Math.sqrt(nearX * nearX + nearY * nearY) - forecast.touch(m);
        double begin = k == 0 ? 0 : forecast.time(k - 1);
        return note(m, gap, begin + share * (forecast.time(k) - begin));
    }

    private double note(int m, double gap, double when) {
        double closeLate = forecast.isShip(m) ? CLOSE_LATE_SHIP : CLOSE_LATE;
        double now = severity(gap, when, forecast.margin(m), forecast.gap(m), closeLate);
        if (now > worstCost) {
            worstCost = now;
            worst = m;
            worstTime = when;
        }
        double more = Math.max(0, now - cost[m]);
        cost[m] += more;
        return more;
    }

    private double severity(double gap, double when, double margin, double start, double closeLate) {
        double f = Math.min(1, when / horizon);
        double need = margin * (NEED_NOW + (1 - NEED_NOW) * f);
        double hard = ALMOST * margin;
        if (start < need) {
            double parted = APART * fullMargin * f;
            need = Math.min(need, Math.max(start, -margin) + parted);
            hard = Math.min(hard, Math.max(start - AT_ONCE * fullMargin, -fullMargin) + parted);
        }
        if (gap >= need) {
            return 0;
        }
        double late = (1 - f) * (1 - f);
        double severity = CLOSE * (closeLate + late) * Math.min(1, (need - gap) / margin);
        if (gap < hard) {
            severity += TOUCH
                    * ((when > horizon ? BEYOND : TOUCH_LATE) + late)
                    * (1 + DEEPER * Math.min(1, (hard - gap) / fullMargin));
            if (gap < GRAZE * fullMargin) {
                double soon = Math.max(0, 1 - f / OVERLAP_WITHIN);
                severity += OVERLAP * soon * soon;
            }
        }
        return severity;
    }

    /** The neighbour that made most of the last risk, as its number in the forecast; negative when none did. */
    int worst() {
        return worst;
    }

    /** When it is closest. */
    double worstTime() {
        return worstTime;
    }
}

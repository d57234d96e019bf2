package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Aabb;
import org.jspecify.annotations.Nullable;

/**
 * How dangerous a course is: the sum over neighbours and walls of the worst that happens with each.
 *
 * <pre>
 *   need(t) = margin · (0.7 + 0.3 t/H)        left = (1 − t/H)²
 *   too close: 4 (c + left) (need − gap) / margin        touching: + 4 (0.15 + left) (1 + 8 depth / margin)
 * </pre>
 *
 * <p>c is 0.02, and 0.2 against ships. The depth tells a graze from a blow: without it a ship in a jam, where every course touches
 * somebody, flew straight into one that crossed. Parting early from ships and counting depth took circles of 200 from 6 meetings in 30
 * seeds to 2 in the same.
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

    private final double[] pathX = new double[Forecast.COUNT];
    private final double[] pathY = new double[Forecast.COUNT];
    private final double[] lastX = new double[Nearest.MOST];
    private final double[] lastY = new double[Nearest.MOST];
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
        int n = forecast.count();
        for (int m = 0; m < n; m++) {
            lastX[m] = forecast.startX(m);
            lastY[m] = forecast.startY(m);
            cost[m] = 0;
        }
        for (int k = 0; k < Forecast.COUNT && risk < bound; k++) {
            risk += until(k, n);
        }
        return risk;
    }

    private void follow(double wx, double wy, double a, double lag) {
        double dx = wx - vx;
        double dy = wy - vy;
        double duration = Manoeuvre.duration(Math.sqrt(dx * dx + dy * dy), a, lag);
        for (int k = 0; k < Forecast.COUNT; k++) {
            pathX[k] = Manoeuvre.at(forecast.time(k), vx, wx, duration);
            pathY[k] = Manoeuvre.at(forecast.time(k), vy, wy, duration);
        }
        double towards = wx * restX + wy * restY;
        if (towards > 0 && Math.abs(wx * restY - wy * restX) <= STRAIGHT * towards) {
            endPath(restX * restX + restY * restY);
        }
    }

    private void endPath(double distanceSquared) {
        for (int k = 0; k < Forecast.COUNT; k++) {
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
            double gap = wallGap(pathX[k], pathY[k]);
            if (gap < WALL * fullMargin) {
                most = Math.max(most, severity(gap, forecast.time(k), WALL * fullMargin, wallGap, CLOSE_LATE));
            }
        }
        return most;
    }

    /** What the stretch before the {@code k}-th time adds, all relative motion in it being straight. */
    private double until(int k, int n) {
        double[] x = forecast.x(k);
        double[] y = forecast.y(k);
        double px = pathX[k];
        double py = pathY[k];
        double begin = k == 0 ? 0 : forecast.time(k - 1);
        double length = forecast.time(k) - begin;
        double added = 0;
        for (int m = 0; m < n; m++) {
            double fromX = lastX[m];
            double fromY = lastY[m];
            double toX = x[m] - px;
            double toY = y[m] - py;
            lastX[m] = toX;
            lastY[m] = toY;
            double dx = toX - fromX;
            double dy = toY - fromY;
            double within = forecast.touch(m) + forecast.margin(m);
            double before = fromX * fromX + fromY * fromY - within * within;
            double towards = -(fromX * dx + fromY * dy);
            double d2 = dx * dx + dy * dy;
            double after = before + d2 - 2 * towards;
            // The last of these is (distance of the line)² < within², without the division; it is seldom true, so it is
            // asked first.
            boolean near = after < 0 || before < 0 || (before * d2 < towards * towards && towards > 0 & towards < d2);
            if (near && (k < Forecast.WITHIN_HORIZON || !forecast.isShip(m))) {
                double share = towards <= 0 ? 0 : towards >= d2 ? 1 : towards / d2;
                double nearX = fromX + share * dx;
                double nearY = fromY + share * dy;
                double gap = Math.sqrt(nearX * nearX + nearY * nearY) - forecast.touch(m);
                added += note(m, gap, begin + share * length);
            }
        }
        return added;
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

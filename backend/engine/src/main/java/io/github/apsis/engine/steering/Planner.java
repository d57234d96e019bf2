package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Period;
import org.jspecify.annotations.Nullable;

/**
 * Chooses a course: the velocity that a ship shall be on its way to until it thinks again.
 *
 * <p>Every candidate is rolled out with the acceleration that the ship has, against where all others will be ({@link Forecast}),
 * which is what acceleration obstacles (van den Berg, Snape, Guy and Manocha 2011, ICRA) do by geometry. What is preferred is flown if it is free
 * of any {@link Risk}; otherwise what costs least:
 *
 * <pre>
 *   (1.2 · slower + 0.5 · faster + c · sideways + n · idle + 0.15 · |w − last course|) / v_max + risk
 * </pre>
 *
 * <p>Slower, faster and sideways are against what is preferred, idle is what is missing to its speed in any direction; c is 0.2 far
 * from a target and 0.6 near it, where a detour does not pay; n is the nearness of the target, 0 to 1: two ships that want to change places
 * must not find it cheapest to wait. The last term keeps two equal threats from making a ship tremble. A draw goes to the side away
 * from the threat, which is tried first, and dead ahead to the right: two ships that meet head-on both give way to the same side.
 */
final class Planner {
    private static final double HORIZON = 25.0 / 6; // stopping times: 2.5 s for 120 units/s and 200 units/s²
    private static final double PERIOD = 1.0 / 15; // stopping times between two plans
    private static final double SQUEEZE = 0.5; // stopping times until contact
    private static final double MARGIN_RADII = 1.5; // of the ship
    private static final double MARGIN_STOPPING = 1.0 / 3; // of the distance in which it stops
    private static final double WAITING_GAP_RADII = 0.2; // of the ship: between its rim and that of the rock
    private static final double USABLE = 0.9; // share of the engine that is planned with

    private static final double ROUNDING = 1 + 1e-9;

    private static final double SLOWER = 1.2;
    private static final double FASTER = 0.5;
    private static final double SIDEWAYS_FAR = 0.2;
    private static final double SIDEWAYS_NEAR = 0.6;
    private static final double IDLE = 1;
    private static final double CHANGE = 0.15;
    private static final double STEP =
            0.08; // of the top speed: how far beside the last course to look for a better one
    private static final double LEAST =
            0.1; // of the engine, that gravity leaves in any direction: outside it is kept clear of

    private final Seek seek;
    private final Neighbours neighbours;
    private final Courses courses;
    private final Nearest nearest;
    private final Forecast forecast;
    private final Risk risk;

    private double vx; // of the ship
    private double vy;
    private double gx; // gravity there
    private double gy;
    private double most; // of the engine, length / time²
    private double top; // speed
    private double lag; // time
    private double ux; // direction of what is preferred
    private double uy;
    private double preferred; // speed
    private double sideways; // weight
    private double near; // 0 to 1
    private int firstSide; // 1 for the right, −1 for the left
    private double lastX; // the course so far
    private double lastY;

    private double best;
    private double bestX;
    private double bestY;

    Planner(
            Seek seek,
            Neighbours neighbours,
            Courses courses,
            double gravity,
            @Nullable Aabb walls,
            @Nullable Period period) {
        this.seek = seek;
        this.neighbours = neighbours;
        this.courses = courses;
        nearest = new Nearest(gravity, period);
        forecast = new Forecast(courses, period);
        risk = new Risk(forecast, walls);
    }

    /** How far a ship looks, from rim to rim. */
    static double range(Bodies bodies, int i) {
        return HORIZON * stoppingTime(bodies, i) * bodies.maxSpeed(i);
    }

    /** In what time a ship at top speed can stop. */
    static double stoppingTime(Bodies bodies, int i) {
        return bodies.maxSpeed(i) / (bodies.maxForce(i) * bodies.inverseMass(i));
    }

    /** Whether the ship thinks again in this tick: not all at once, twice as often in a squeeze, and at once when it is new. */
    static boolean isDue(Bodies bodies, int i, long tick, double dt) {
        double stopping = stoppingTime(bodies, i);
        double period = bodies.contactIn(i) < SQUEEZE * stopping ? 0.5 * PERIOD : PERIOD;
        int ticks = (int) Math.min(1000, Math.max(1, Math.rint(period * stopping / dt)));
        return (tick + bodies.idValue(i)) % ticks == 0 || !bodies.hasLooked(i);
    }

    /**
     * Sets the course of the ship in slot {@code i}.
     *
     * @param wish the velocity that it prefers; becomes another where its target is covered
     * @param nearness of its target, 0 when it has none or it is far to 1 within the slowing radius
     */
    void plan(Bodies bodies, int i, SteeringVector wish, double nearness, double dt) {
        double stopping = stoppingTime(bodies, i);
        double horizon = HORIZON * stopping;
        double range = range(bodies, i);
        double margin =
                Math.min(MARGIN_RADII * bodies.radius(i), MARGIN_STOPPING * 0.5 * bodies.maxSpeed(i) * stopping);
        see(bodies, i);
        nearest.find(neighbours, bodies, i, top, most, range, horizon);
        forecast.look(bodies, i, nearest, horizon, top, Math.max(top, wish.length()), margin);
        risk.begin(bodies, i, range, horizon, margin);
        bodies.setThreat(i, 0, Double.POSITIVE_INFINITY);
        if (!risk.isAnythingNear()) {
            bodies.setCourse(i, wish.x, wish.y, false);
            return;
        }
        boolean waits = nearness == 1 && waitBesideRock(bodies, i, dt, wish);
        double px = wish.x;
        double py = wish.y;
        prefer(px, py, nearness);
        lag = nearness < 1 ? Helm.response(bodies, i) : 0;
        double riskOfPreferred = risk.of(px, py, accelerationTo(px, py), lag, Double.MAX_VALUE);
        firstSide = 1;
        int worst = risk.worst();
        if (worst >= 0) {
            bodies.setThreat(i, bodies.idValue(nearest.slot(worst)), risk.worstTime());
            boolean onTheRight = ux * forecast.startY(worst) < uy * forecast.startX(worst);
            firstSide = onTheRight ? -1 : 1;
        }
        if (riskOfPreferred == 0) {
            bodies.setCourse(i, px, py, waits);
            return;
        }
        best = Double.MAX_VALUE;
        best = detour(px, py) + riskOfPreferred;
        bestX = px;
        bestY = py;
        lag = Helm.response(bodies, i);
        tryAll(courses.isEvading(i), STEP * bodies.maxSpeed(i));
        bodies.setCourse(i, bestX, bestY, waits || bestX != px || bestY != py);
    }

    /** Where a rock lies on the target, prefers the free place closest to it instead of circling the rock. */
    private boolean waitBesideRock(Bodies bodies, int i, double dt, SteeringVector wish) {
        double dx = bodies.targetX(i) - bodies.x(i);
        double dy = bodies.targetY(i) - bodies.y(i);
        double gap = WAITING_GAP_RADII * bodies.radius(i);
        int m = forecast.rockOn(dx, dy, gap);
        if (m < 0) {
            return false;
        }
        double fromX = dx - forecast.startX(m);
        double fromY = dy - forecast.startY(m);
        double from = Math.sqrt(fromX * fromX + fromY * fromY);
        if (from > 0) { // in the very middle any side is as good: the ship stays where it is going
            double out = (forecast.touch(m) + gap) / from;
            double restX = forecast.startX(m) + out * fromX;
            double restY = forecast.startY(m) + out * fromY;
            seek.towards(bodies, i, restX, restY, dt, wish);
            risk.restAt(restX, restY);
        }
        return true;
    }

    private void see(Bodies bodies, int i) {
        vx = bodies.vx(i);
        vy = bodies.vy(i);
        gx = bodies.ax(i);
        gy = bodies.ay(i);
        most = USABLE * bodies.maxForce(i) * bodies.inverseMass(i);
        top = Math.max(bodies.maxSpeed(i), Math.sqrt(vx * vx + vy * vy));
        lastX = courses.x(i);
        lastY = courses.y(i);
    }

    private void prefer(double px, double py, double nearness) {
        preferred = Math.sqrt(px * px + py * py);
        double speed = Math.sqrt(vx * vx + vy * vy);
        if (preferred > 1e-9 * top) {
            ux = px / preferred;
            uy = py / preferred;
        } else {
            ux = speed > 0 ? vx / speed : 1;
            uy = speed > 0 ? vy / speed : 0;
        }
        near = nearness;
        sideways = SIDEWAYS_FAR + (SIDEWAYS_NEAR - SIDEWAYS_FAR) * nearness;
    }

    private void tryAll(boolean evading, double step) {
        if (evading) {
            consider(lastX, lastY);
            consider(lastX + step * ux, lastY + step * uy);
            consider(lastX - step * ux, lastY - step * uy);
            consider(lastX + firstSide * step * uy, lastY - firstSide * step * ux);
            consider(lastX - firstSide * step * uy, lastY + firstSide * step * ux);
        }
        consider(vx, vy);
        for (int c = 0; c < Candidates.count(); c++) {
            double along = top * Candidates.along(c);
            double across = firstSide * top * Candidates.across(c);
            if (offPreferred(along - preferred, across) < ROUNDING * best * top) {
                consider(along * ux - across * uy, along * uy + across * ux);
            }
        }
        consider(0, 0);
    }

    private void consider(double x, double y) {
        double w2 = x * x + y * y;
        double cut = w2 > top * top ? top / Math.sqrt(w2) : 1;
        double wx = x * cut;
        double wy = y * cut;
        double cost = detour(wx, wy);
        if (cost >= best) {
            return;
        }
        cost += risk.of(wx, wy, accelerationTo(wx, wy), lag, best - cost);
        if (cost < best) {
            best = cost;
            bestX = wx;
            bestY = wy;
        }
    }

    /** What a course costs without any risk; less than that where the part known already is too much. */
    private double detour(double wx, double wy) {
        double faster = wx * ux + wy * uy - preferred;
        double left = wy * ux - wx * uy;
        double cost = offPreferred(faster, left);
        if (near > 0) {
            cost += IDLE * near * Math.max(0, preferred - Math.sqrt(wx * wx + wy * wy));
        }
        if (cost >= best * top) {
            return cost / top;
        }
        double dx = wx - lastX;
        double dy = wy - lastY;
        return (cost + CHANGE * Math.sqrt(dx * dx + dy * dy)) / top;
    }

    private double offPreferred(double faster, double left) {
        return Math.max(FASTER * faster, -SLOWER * faster) + sideways * Math.abs(left);
    }

    /** What the engine can do towards a velocity: gravity helps in its own direction and takes what it pulls aside. */
    private double accelerationTo(double wx, double wy) {
        double dx = wx - vx;
        double dy = wy - vy;
        double change = Math.sqrt(dx * dx + dy * dy);
        if (change == 0 || (gx == 0 && gy == 0)) {
            return most;
        }
        double across = (gx * dy - gy * dx) / change;
        double along = (gx * dx + gy * dy) / change;
        return Math.max(LEAST * most, along + Math.sqrt(Math.max(0, most * most - across * across)));
    }
}

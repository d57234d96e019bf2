package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import org.jspecify.annotations.Nullable;

/**
 * Where the neighbours of a ship will be, relative to where it is now, at some times up to the horizon.
 *
 * <p>Ships fly the course that they have chosen last: that others know it is what makes a crowd flow (circle of 200: a third of the
 * collisions of the same planner that lets them fly straight on, and none with what follows from it). Everything else falls: a
 * parabola, bent as a circle where the pull is across,
 *
 * <pre>
 *   r + v (t − ω² t³/6) + a t²/2,   ω = |v × a| / v²
 * </pre>
 *
 * <p>which an asteroid on an orbit of 300 leaves by half a unit in 2.5 s.
 */
final class Forecast {
    /**
     * When, in shares of the horizon; in between all motion is taken as straight. A look beyond the horizon is for rocks that close
     * a gap slowly: without it one ship in a hundred was caught where they fill a sixth of the area.
     */
    private static final double[] TIMES = {0.048, 0.12, 0.22, 0.36, 0.6, 1.0, 1.6};

    private static final int SOON = 3; // of these times: 0.9 s for 120 units/s and 200 units/s²

    static final int COUNT = TIMES.length;

    /** How many of these concern ships and walls: beyond the horizon there are rocks alone. */
    static final int WITHIN_HORIZON = COUNT - 1;

    private static final double ROUNDING = 1 + 1e-9;
    private static final double LONGEST_BEND = 2; // (ωt)², beyond it the series is of no use
    private static final double CALM_ROCK = 0.3; // of the margin, against what moves along with the ship
    private static final double ROCK = 0.45; // of the margin: a rock has no mind to change
    private static final double ROCK_SPEED = 0.5; // relative, of the top speed, from which on the margin is whole
    private static final double CALM_SHIP = 0.7;
    private static final double SHIP_SPEED = 0.4;

    private final Courses courses;
    private final @Nullable Period period;
    private final double[] time = new double[COUNT];
    private final double[][] x = new double[COUNT][Nearest.MOST];
    private final double[][] y = new double[COUNT][Nearest.MOST];
    private final double[] startX = new double[Nearest.MOST];
    private final double[] startY = new double[Nearest.MOST];
    private final double[] touch = new double[Nearest.MOST]; // distance of the centres at which rims touch
    private final double[] gap = new double[Nearest.MOST]; // now, length
    private final double[] margin = new double[Nearest.MOST]; // length
    private final double[] keepOut = new double[Nearest.MOST]; // touch and margin
    private final boolean[] ship = new boolean[Nearest.MOST];
    private final double[] earliest = new double[Nearest.MOST]; // time before which it cannot be close
    private final int[] within = new int[COUNT];
    private int count;

    Forecast(Courses courses, @Nullable Period period) {
        this.courses = courses;
        this.period = period;
    }

    /**
     * Looks ahead for the ship in slot {@code i}.
     *
     * @param fastest speed of any course that it will try
     */
    void look(
            Bodies bodies, int i, Nearest nearest, double horizon, double topSpeed, double fastest, double fullMargin) {
        count = nearest.count();
        for (int k = 0; k < COUNT; k++) {
            time[k] = TIMES[k] * horizon;
        }
        for (int m = 0; m < count; m++) {
            int j = nearest.slot(m);
            double dx = bodies.x(j) - bodies.x(i);
            double dy = bodies.y(j) - bodies.y(i);
            startX[m] = period == null ? dx : period.nearestX(dx);
            startY[m] = period == null ? dy : period.nearestY(dy);
            touch[m] = nearest.size(j) + bodies.radius(i);
            gap[m] = Math.sqrt(startX[m] * startX[m] + startY[m] * startY[m]) - touch[m];
            double dvx = bodies.vx(j) - bodies.vx(i);
            double dvy = bodies.vy(j) - bodies.vy(i);
            double relative = Math.sqrt(dvx * dvx + dvy * dvy) / topSpeed;
            ship[m] = bodies.isShip(j) && !bodies.isFixed(j);
            if (ship[m]) {
                margin[m] = fullMargin * Math.min(1, CALM_SHIP + relative / SHIP_SPEED);
                foreseeShip(bodies, j, m);
            } else {
                margin[m] = ROCK * fullMargin * Math.min(1, CALM_ROCK + relative / ROCK_SPEED);
                foreseeFall(bodies, j, m);
            }
            keepOut[m] = touch[m] + margin[m];
            earliest[m] = earliest(bodies, j, m, fastest);
        }
        countWithin();
    }

    /** How long it takes at least until the two are closer than they should be, if each flies straight at the other. */
    private double earliest(Bodies bodies, int j, int m, double fastest) {
        double v2 = square(bodies.vx(j), bodies.vy(j));
        double gained = 0;
        if (ship[m]) {
            v2 = Math.max(v2, square(courses.x(j), courses.y(j)));
        } else {
            gained = 0.5 * time[COUNT - 1] * Math.sqrt(square(bodies.ax(j), bodies.ay(j)));
        }
        return (gap[m] - margin[m]) / (ROUNDING * (fastest + Math.sqrt(v2) + gained));
    }

    /** Neighbours come by urgency, so those that can be close soon are about the first. */
    private void countWithin() {
        int n = count;
        for (int k = COUNT - 1; k >= 0; k--) {
            while (n > 0 && (earliest[n - 1] > time[k] || (k >= WITHIN_HORIZON && ship[n - 1]))) {
                n--;
            }
            within[k] = n;
            if (k == WITHIN_HORIZON) {
                n = count;
            }
        }
    }

    private void foreseeShip(Bodies bodies, int j, int m) {
        double vx = bodies.vx(j);
        double vy = bodies.vy(j);
        double dx = courses.x(j) - vx;
        double dy = courses.y(j) - vy;
        double a = bodies.maxForce(j) * bodies.inverseMass(j);
        double lag = courses.isEvading(j) ? Helm.response(bodies, j) : 0;
        double duration = Manoeuvre.duration(Math.sqrt(dx * dx + dy * dy), a, lag);
        for (int k = 0; k < COUNT; k++) {
            x[k][m] = startX[m] + Manoeuvre.at(time[k], vx, courses.x(j), duration);
            y[k][m] = startY[m] + Manoeuvre.at(time[k], vy, courses.y(j), duration);
        }
    }

    private void foreseeFall(Bodies bodies, int j, int m) {
        double vx = bodies.vx(j);
        double vy = bodies.vy(j);
        double ax = bodies.ax(j);
        double ay = bodies.ay(j);
        double v2 = vx * vx + vy * vy;
        double cross = vx * ay - vy * ax;
        double turn2 = v2 > 0 ? cross * cross / (v2 * v2) : 0;
        for (int k = 0; k < COUNT; k++) {
            double t = time[k];
            double bend = turn2 * t * t;
            double along = bend < LONGEST_BEND ? t * (1 - bend / 6) : t;
            x[k][m] = startX[m] + vx * along + 0.5 * ax * t * t;
            y[k][m] = startY[m] + vy * along + 0.5 * ay * t * t;
        }
    }

    /** The rock that lies on a place, now and still when a ship could be there; negative when there is none. */
    int rockOn(double px, double py, double clearance) {
        for (int m = 0; m < count; m++) {
            double within = touch[m] + clearance;
            if (!ship[m]
                    && square(startX[m] - px, startY[m] - py) < within * within
                    && square(x[SOON][m] - px, y[SOON][m] - py) < within * within) {
                return m;
            }
        }
        return -1;
    }

    private static double square(double dx, double dy) {
        return dx * dx + dy * dy;
    }

    /** Of how many neighbours, from the first, any could be near in the {@code k}-th stretch or before. */
    int within(int k) {
        return within[k];
    }

    int count() {
        return count;
    }

    double time(int k) {
        return time[k];
    }

    /** Where the neighbours are at the begin of the {@code k}-th stretch. */
    double[] fromX(int k) {
        return k == 0 ? startX : x[k - 1];
    }

    double[] fromY(int k) {
        return k == 0 ? startY : y[k - 1];
    }

    /** Where they are at its end. */
    double[] toX(int k) {
        return x[k];
    }

    double[] toY(int k) {
        return y[k];
    }

    boolean isShip(int m) {
        return ship[m];
    }

    double startX(int m) {
        return startX[m];
    }

    double startY(int m) {
        return startY[m];
    }

    double touch(int m) {
        return touch[m];
    }

    /** Distances of the centres at which a ship is close: touch and margin. */
    double[] keepOut() {
        return keepOut;
    }

    double gap(int m) {
        return gap[m];
    }

    double margin(int m) {
        return margin[m];
    }
}

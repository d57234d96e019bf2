package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import org.jspecify.annotations.Nullable;

/**
 * The most urgent neighbours of a ship, by the time until they could touch.
 *
 * <pre>
 *   urgency = gap / (closing speed + v_max / 3)
 * </pre>
 *
 * <p>In the jam of 200 ships at the centre of a circle 24 of them are needed: with 16 a ship in a hundred was hit by one that
 * it did not look at. Ships are looked at for 0.6 of the horizon: they change their minds, and a crowd costs a quarter less.
 */
final class Nearest {
    /** How many are looked at. */
    static final int MOST = 24;

    /** Positions in one {@link #sift}: what is taken in from some of them leaves less to offer from the next. */
    static final int AT_ONCE = 64;

    private static final double BASE = 1.0 / 3; // of the top speed: what either may still add to the approach
    private static final double ROCKS = 1.6; // of the horizon, as the next
    private static final double SHIPS = 0.6;
    private static final double[] SHARE = {ROCKS, SHIPS}; // without a branch
    private static final double ROUNDING = 1 + 1e-9;
    private static final double ESCAPABLE = 0.8; // share of a ship's largest acceleration that gravity may take

    private final double gravity; // G, length³ / (mass · time²)
    private final @Nullable Period period;

    private Bodies bodies = new Bodies(); // of the present search, as all below
    private int self;
    private double x;
    private double y;
    private double vx;
    private double vy;
    private double radius;
    private double reach; // from rim to rim, length
    private double idle; // the same to what does not come closer
    private double base; // speed
    private double horizon; // time
    private double escapable; // acceleration

    private double pull; // size of what gravity keeps a ship from leaving, length / mass^(1/2)
    private final int[] found = new int[AT_ONCE];
    private final double[] latest = new double[SHARE.length]; // urgency that is wanted, of rocks and of ships

    private int count;
    private final int[] slot = new int[MOST];
    private final double[] urgency = new double[MOST]; // time, ascending

    Nearest(double gravity, @Nullable Period period) {
        this.gravity = gravity;
        this.period = period;
    }

    /** Finds the neighbours of the ship in slot {@code i}. */
    void find(
            Neighbours neighbours,
            Bodies of,
            int i,
            double topSpeed,
            double mostAcceleration,
            double range,
            double until) {
        bodies = of;
        self = i;
        vx = of.vx(i);
        vy = of.vy(i);
        radius = of.radius(i);
        reach = range + radius;
        base = BASE * topSpeed;
        horizon = until;
        idle = ROCKS * base * horizon;
        escapable = ESCAPABLE * mostAcceleration;
        pull = gravity > 0 ? Math.sqrt(gravity / escapable) : 0;
        count = 0;
        int images = period == null ? 0 : 1; // on each side
        for (int column = -images; column <= images; column++) {
            for (int row = -images; row <= images; row++) {
                x = of.x(i) + (period == null ? 0 : column * period.width());
                y = of.y(i) + (period == null ? 0 : row * period.height());
                neighbours.search(x, y, this);
            }
        }
    }

    /**
     * Of the bodies at these positions, of {@link #AT_ONCE} at most, finds those that may be urgent enough beside what has been taken
     * in, and a few more, and returns how many. There is no branch in it: which they are is as good as random, and a search took
     * twice as long with one.
     */
    int sift(Neighbours all, int from, int to) {
        double last = count < MOST ? Double.POSITIVE_INFINITY : urgency[MOST - 1];
        for (int kind = 0; kind < latest.length; kind++) {
            latest[kind] = Math.min(SHARE[kind] * horizon, last);
        }
        double[] until = latest;
        int[] into = found;
        int[] items = all.item;
        double[] xs = all.x;
        double[] ys = all.y;
        double[] roots = all.rootMass;
        double[] motions = all.motion;
        int n = 0;
        for (int p = from; p < to; p++) {
            double dx = xs[p] - x;
            double dy = ys[p] - y;
            double d2 = dx * dx + dy * dy;
            double d = Math.sqrt(d2);
            double closing = Math.max(0, -((motions[3 * p] - vx) * dx + (motions[3 * p + 1] - vy) * dy));
            double size = Math.max(motions[3 * p + 2], pull * roots[p]);
            double within = (size + radius) * d + until[items[p] >>> 31] * (base * d + closing);
            into[n] = p;
            n += 1 - (int) (Double.doubleToRawLongBits(ROUNDING * within - d2) >>> 63); // 1 unless it is negative
        }
        return n;
    }

    /** How far from the ship the centre of a body that is no larger, heavier or faster than this can be and still be taken in, length. */
    double farthest(double largestRadius, double largestRootMass, double speed) {
        double last = count < MOST ? Double.POSITIVE_INFINITY : urgency[MOST - 1];
        double until = Math.min(ROCKS * horizon, last);
        double size = Math.max(largestRadius, pull * largestRootMass);
        double urgent = size + radius + until * (base + Math.sqrt(vx * vx + vy * vy) + speed);
        return ROUNDING * Math.min(largestRadius + radius + reach, urgent);
    }

    /** A position that the last sift has found. */
    int found(int f) {
        return found[f];
    }

    /** Takes a body in if it is among the most urgent so far. */
    void offer(Neighbours all, int p) {
        int j = all.slot(p);
        double dx = all.x[p] - x;
        double dy = all.y[p] - y;
        double d2 = dx * dx + dy * dy;
        double closing = -((all.motion[3 * p] - vx) * dx + (all.motion[3 * p + 1] - vy) * dy); // times the distance
        double far = all.motion[3 * p + 2] + radius + (closing > 0 ? reach : idle);
        if (d2 > far * far || j == self || !isNearestImage(dx, dy)) {
            return;
        }
        double d = Math.sqrt(d2);
        double gap = d - size(j) - radius;
        double speed = base * d + Math.max(0, closing); // times the distance, like the next line
        if (gap * d > SHARE[all.item[p] >>> 31] * horizon * speed) {
            return;
        }
        insert(j, d > 0 ? gap * d / speed : gap);
    }

    private boolean isNearestImage(double dx, double dy) {
        return period == null || (Math.abs(dx) <= 0.5 * period.width() && Math.abs(dy) <= 0.5 * period.height());
    }

    private void insert(int j, double when) {
        int at;
        if (count < MOST) {
            at = count++;
        } else if (when < urgency[MOST - 1]) {
            at = MOST - 1;
        } else {
            return;
        }
        while (at > 0 && urgency[at - 1] > when) {
            urgency[at] = urgency[at - 1];
            slot[at] = slot[at - 1];
            at--;
        }
        urgency[at] = when;
        slot[at] = j;
    }

    /** The radius of a body, or of the circle around it inside which a ship could hardly leave it, the larger of the two. */
    double size(int j) {
        double size = bodies.radius(j);
        double pull = gravity * bodies.mass(j) / escapable;
        return pull > size * size ? Math.sqrt(pull) : size;
    }

    int count() {
        return count;
    }

    int slot(int m) {
        return slot[m];
    }
}

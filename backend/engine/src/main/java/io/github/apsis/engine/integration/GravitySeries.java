package io.github.apsis.engine.integration;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.Ledger;
import java.util.Arrays;

/**
 * The Taylor series in time of all positions under Newton's gravity, about one moment.
 *
 * <p>Every quantity of a pair is a power series, and its coefficients follow from those before (Moore 1966, "Interval
 * Analysis"; Jorba and Zou 2005, Exp. Math. 14, 99). With d = r_j − r_i, s = |d|² + ε² and w = G s^(−3/2), and [k] for the
 * k-th coefficient:
 *
 * <pre>
 *   s[k] = Σ_l d[l] · d[k−l]
 *   w[k] = −1/s[0] · Σ_(l≥1) (1 + l/2k) s[l] w[k−l]
 *   r_i[k+2] = Σ_j m_j Σ_l d[l] w[k−l] / ((k+1)(k+2))
 * </pre>
 *
 * <p>Exact but for rounding and the cut at the last order. Separations include the low parts of the positions, each pull is
 * rounded once and is the same in all its coefficients, and what it does first, to the acceleration, is summed in two doubles.
 * Costs n²/2 · 5/2 · order² multiplications, 0.4 µs a pair.
 */
final class GravitySeries {
    private final double g; // length³ / (mass · time²)
    private final double softeningSquared; // length²
    private final double fieldX; // length / time²
    private final double fieldY;
    private final int order;
    private final int stride;

    private final TwoDoubles along = new TwoDoubles();
    private final TwoDoubles across = new TwoDoubles();
    private double unit = 1; // of time, in which the coefficients are: a power of two
    private int count;

    // Of bodies: coefficient k of body i at i · stride + k.
    private double[] x = new double[0];
    private double[] y = new double[0];
    private double[] mass = new double[0];
    private boolean[] free = new boolean[0];
    private double[] low = new double[0]; // low parts of x, y, vx, vy and of the second coefficients of x and y
    private final OutsideImpulses outside;
    private double[] sum = new double[0]; // of the pulls on each body: x, y, and their low parts

    // Of pairs: coefficient k of pair p at p · stride + k.
    private double[] dx = new double[0];
    private double[] dy = new double[0];
    private double[] s = new double[0];
    private double[] w = new double[0];
    private double[] inverse = new double[0]; // 1/s[0], and 0 for a pair that does not act

    GravitySeries(double g, double softening, double fieldX, double fieldY, int order) {
        this.g = g;
        this.softeningSquared = softening * softening;
        this.fieldX = fieldX;
        this.fieldY = fieldY;
        this.order = order;
        this.stride = order + 1;
        this.outside = new OutsideImpulses(stride);
    }

    /**
     * Computes all coefficients about the present state.
     *
     * @param timeUnit of the coefficients, near the step that is to come: in others they leave the range of doubles when a pair
     *     is very close or a body very fast
     */
    void expand(Bodies bodies, double timeUnit) {
        unit = Math.scalb(1.0, Math.getExponent(timeUnit));
        begin(bodies);
        lead(bodies);
        for (int k = 1; k <= order - 2; k++) {
            extend(k);
        }
    }

    private void begin(Bodies bodies) {
        count = bodies.count();
        outside.clear(count);
        if (count * stride > x.length) {
            grow(count);
        }
        for (int i = 0; i < count; i++) {
            int at = i * stride;
            x[at] = bodies.x(i);
            y[at] = bodies.y(i);
            x[at + 1] = bodies.vx(i) * unit;
            y[at + 1] = bodies.vy(i) * unit;
            low[6 * i] = bodies.xLow(i);
            low[6 * i + 1] = bodies.yLow(i);
            low[6 * i + 2] = bodies.vxLow(i) * unit;
            low[6 * i + 3] = bodies.vyLow(i) * unit;
            mass[i] = bodies.mass(i);
            free[i] = !bodies.isFixed(i);
            if (free[i]) {
                outside.push(i, mass[i] * fieldX + bodies.thrustX(i), mass[i] * fieldY + bodies.thrustY(i));
            }
        }
    }

    private void grow(int bodies) {
        int pairs = bodies * (bodies - 1) / 2;
        x = new double[bodies * stride];
        y = new double[bodies * stride];
        mass = new double[bodies];
        free = new boolean[bodies];
        low = new double[6 * bodies];
        sum = new double[4 * bodies];
        dx = new double[pairs * stride];
        dy = new double[pairs * stride];
        s = new double[pairs * stride];
        w = new double[pairs * stride];
        inverse = new double[pairs];
    }

    /** The shortest time in which a pair meets or turns: a unit for the first expansion. */
    double shortestTime(Bodies bodies) {
        double shortest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < bodies.count(); i++) {
            for (int j = i + 1; j < bodies.count(); j++) {
                double d = Math.hypot(bodies.x(j) - bodies.x(i), bodies.y(j) - bodies.y(i));
                double speed = Math.hypot(bodies.vx(j) - bodies.vx(i), bodies.vy(j) - bodies.vy(i));
                double pull = g * (bodies.mass(i) + bodies.mass(j));
                if (d > 0) {
                    shortest = Math.min(shortest, Math.min(d / speed, d * Math.sqrt(d / pull)));
                }
            }
        }
        return shortest;
    }

    // --- the leading coefficient, in pairs of doubles ---

    private void lead(Bodies bodies) {
        Arrays.fill(sum, 0, 4 * count, 0);
        int pair = 0;
        for (int i = 0; i < count; i++) {
            for (int j = i + 1; j < count; j++) {
                leadPair(i, j, pair++);
            }
        }
        for (int i = 0; i < count; i++) {
            setCoefficients(i, 0, 2, sum[4 * i], sum[4 * i + 1]);
            if (free[i]) {
                x[i * stride + 2] += 0.5 * (fieldX + bodies.thrustX(i) * bodies.inverseMass(i)) * unit * unit;
                y[i * stride + 2] += 0.5 * (fieldY + bodies.thrustY(i) * bodies.inverseMass(i)) * unit * unit;
            }
            low[6 * i + 4] = free[i] ? 0.5 * sum[4 * i + 2] : 0;
            low[6 * i + 5] = free[i] ? 0.5 * sum[4 * i + 3] : 0;
        }
    }

    private void leadPair(int i, int j, int pair) {
        int at = pair * stride;
        double ddx = x[j * stride] - x[i * stride] + (low[6 * j] - low[6 * i]);
        double ddy = y[j * stride] - y[i * stride] + (low[6 * j + 1] - low[6 * i + 1]);
        double xx = ddx * ddx;
        double yy = ddy * ddy;
        double xxyy = xx + yy;
        double d2 = xxyy + softeningSquared;
        double root = Math.sqrt(d2);
        double d3 = d2 * root;
        dx[at] = ddx;
        dy[at] = ddy;
        s[at] = d2;
        if (!(d3 >= Double.MIN_NORMAL && d3 <= Double.MAX_VALUE)) {
            w[at] = 0; // coincident centres have no direction, and what is so far away does not pull
            inverse[pair] = 0;
            return;
        }
        // One rounding in place of six: the same pull in all orders, wrong by half a bit, keeps energy three times
        // better.
        double d2Low = TwoDoubles.lost(xx, yy, xxyy)
                + TwoDoubles.lost(xxyy, softeningSquared, d2)
                + (Math.fma(ddx, ddx, -xx) + Math.fma(ddy, ddy, -yy));
        double rootLow = (Math.fma(-root, root, d2) + d2Low) / (2 * root);
        double d3Low = Math.fma(d2, root, -d3) + d2 * rootLow + d2Low * root;
        double pull = g * (unit * unit) / d3;
        pull += (Math.fma(-pull, d3, g * (unit * unit)) - pull * d3Low) / d3;
        w[at] = pull;
        inverse[pair] = 1 / d2;
        double fx = ddx * pull;
        double fy = ddy * pull;
        double fxl = Math.fma(ddx, pull, -fx);
        double fyl = Math.fma(ddy, pull, -fy);
        pull(4 * i, mass[j], fx, fxl, fy, fyl);
        pull(4 * j, -mass[i], fx, fxl, fy, fyl);
    }

    private void pull(int at, double m, double fx, double fxl, double fy, double fyl) {
        double px = m * fx;
        double py = m * fy;
        double sx = sum[at] + px;
        double sy = sum[at + 1] + py;
        sum[at + 2] += TwoDoubles.lost(sum[at], px, sx) + (Math.fma(m, fx, -px) + m * fxl);
        sum[at + 3] += TwoDoubles.lost(sum[at + 1], py, sy) + (Math.fma(m, fy, -py) + m * fyl);
        sum[at] = sx;
        sum[at + 1] = sy;
    }

    // --- the coefficients behind it ---

    private void extend(int k) {
        Arrays.fill(sum, 0, 4 * count, 0);
        int pair = 0;
        for (int i = 0; i < count; i++) {
            for (int j = i + 1; j < count; j++, pair++) {
                double ddx = x[j * stride + k] - x[i * stride + k];
                double ddy = y[j * stride + k] - y[i * stride + k];
                if (k == 1) {
                    ddx += low[6 * j + 2] - low[6 * i + 2];
                    ddy += low[6 * j + 3] - low[6 * i + 3];
                }
                extendPair(i, j, pair, k, ddx, ddy);
            }
        }
        // A quotient, not a product with 1/((k+1)(k+2)): that one's rounding is the same at every step and takes energy
        // with it,
        // 2.8e-13 over 10 000 periods of the figure-eight in place of 1.3e-14.
        double divisor = (k + 1) * (k + 2);
        for (int i = 0; i < count; i++) {
            setCoefficients(i, k, divisor, sum[4 * i], sum[4 * i + 1]);
        }
    }

    /** The acceleration of a free body makes its position; that of a fixed one is what it is held against. */
    private void setCoefficients(int i, int k, double divisor, double ax, double ay) {
        x[i * stride + k + 2] = free[i] ? ax / divisor : 0;
        y[i * stride + k + 2] = free[i] ? ay / divisor : 0;
        if (!free[i]) {
            outside.hold(k, mass[i] * ax, mass[i] * ay, x[i * stride], y[i * stride]);
        }
    }

    private void extendPair(int i, int j, int pair, int k, double ddx, double ddy) {
        int at = pair * stride;
        int top = at + k;
        if (inverse[pair] == 0) {
            w[top] = 0;
            return;
        }
        dx[top] = ddx;
        dy[top] = ddy;
        double square = 0;
        double squareY = 0;
        int half = (k + 1) / 2;
        for (int l = 0; l < half; l++) {
            square += dx[at + l] * dx[top - l];
            squareY += dy[at + l] * dy[top - l];
        }
        double sk = 2 * (square + squareY);
        if ((k & 1) == 0) {
            double mx = dx[at + k / 2];
            double my = dy[at + k / 2];
            sk += mx * mx + my * my;
        }
        s[top] = sk;
        double sw = 0;
        double fx = 0;
        double fy = 0;
        for (int l = 1; l <= k; l++) {
            double wl = w[top - l];
            sw += (2 * k + l) * (s[at + l] * wl); // the factor is exact
            fx += dx[at + l] * wl;
            fy += dy[at + l] * wl;
        }
        double wk = -inverse[pair] * (sw / (2 * k));
        w[top] = wk;
        fx += dx[at] * wk;
        fy += dy[at] * wk;
        sum[4 * i] += mass[j] * fx;
        sum[4 * i + 1] += mass[j] * fy;
        sum[4 * j] -= mass[i] * fx;
        sum[4 * j + 1] -= mass[i] * fy;
    }

    // --- how far it reaches ---

    /**
     * The longest step whose last two terms change no separation by more than this share of it, which stays within half the
     * radius of convergence of every pair's pull, and in which no acceleration changes a separation by more than a given share.
     */
    double reach(double error, double mostBend) {
        double last = 0;
        double lastButOne = 0;
        double pull = 0;
        double bend = 0;
        int pair = 0;
        for (int i = 0; i < count; i++) {
            for (int j = i + 1; j < count; j++, pair++) {
                double inverseDistance = Math.sqrt(inverse[pair]);
                last = Math.max(last, separation(i, j, order) * inverseDistance);
                lastButOne = Math.max(lastButOne, separation(i, j, order - 1) * inverseDistance);
                bend = Math.max(bend, separation(i, j, 2) * inverseDistance);
                double now = w[pair * stride];
                pull = Math.max(pull, now == 0 ? 0 : Math.abs(w[pair * stride + order - 2] / now));
            }
        }
        double accurate = Math.min(root(error / last, order), root(error / lastButOne, order - 1));
        double smooth = Math.min(0.5 * root(1 / pull, order - 2), root(mostBend / bend, 2));
        return Math.min(accurate, smooth) * unit;
    }

    /** Coefficient k of a separation, in the sum norm: its square would overflow in a close encounter. */
    private double separation(int i, int j, int k) {
        return Math.abs(x[j * stride + k] - x[i * stride + k]) + Math.abs(y[j * stride + k] - y[i * stride + k]);
    }

    /**
     * The n-th root to half a percent, which is enough for a step, and with the same bits everywhere: log2 and 2^x by
     * parabolas.
     */
    private static double root(double value, int n) {
        if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
            return value > 0 ? value : 0; // NaN reaches nowhere
        }
        int exponent = Math.getExponent(value);
        double m = Math.scalb(value, -exponent) - 1;
        double log = (exponent + m * (1.3465 - 0.3465 * m)) / n;
        double whole = Math.floor(log);
        double part = log - whole;
        return Math.scalb(1 + part * (0.6565 + 0.3435 * part), (int) whole);
    }

    /** Books the impulses of fields, of thrust and of what holds fixed bodies, and their moments, between two times. */
    void bookOutside(Ledger ledger, double from, double to) {
        outside.book(ledger, x, y, from, to, unit);
    }

    /**
     * Turns the closest pair round, if it closes: the limit of an orbit whose eccentricity goes to 1 is a bounce without loss
     * (Levi-Civita 1920, Acta Math. 42, 99).
     *
     * @return whether there was such a pair
     */
    boolean bounceClosest(Bodies bodies) {
        int first = -1;
        int second = -1;
        double largest = 0;
        int pair = 0;
        for (int i = 0; i < count; i++) {
            for (int j = i + 1; j < count; j++, pair++) {
                double ratio = separation(i, j, order) * Math.sqrt(inverse[pair]);
                if (ratio > largest) {
                    largest = ratio;
                    first = i;
                    second = j;
                }
            }
        }
        return first >= 0 && bounce(bodies, first, second);
    }

    private boolean bounce(Bodies bodies, int i, int j) {
        double nx = x[j * stride] - x[i * stride] + (low[6 * j] - low[6 * i]);
        double ny = y[j * stride] - y[i * stride] + (low[6 * j + 1] - low[6 * i + 1]);
        double wx = bodies.vx(j) - bodies.vx(i);
        double wy = bodies.vy(j) - bodies.vy(i);
        double closing = -(nx * wx + ny * wy);
        double inverseMasses = bodies.inverseMass(i) + bodies.inverseMass(j);
        // What merely flies past is faster than a fall from afar would make it.
        boolean falls = (wx * wx + wy * wy) * Math.hypot(nx, ny) < 4 * g * (mass[i] + mass[j]);
        if (!(closing > 0 && inverseMasses > 0 && falls)) {
            return false;
        }
        double impulse = 2 * closing / (inverseMasses * (nx * nx + ny * ny));
        bodies.push(i, -impulse * nx * bodies.inverseMass(i), -impulse * ny * bodies.inverseMass(i));
        bodies.push(j, impulse * nx * bodies.inverseMass(j), impulse * ny * bodies.inverseMass(j));
        return true;
    }

    // --- paths to look at ---

    DensePath newPath() {
        return new DensePath(order);
    }

    /** Copies the path of body j as it is seen from body i. */
    void copyPath(int i, int j, DensePath path) {
        int a = i * stride;
        int b = j * stride;
        path.begin(unit);
        path.set(0, x[b] - x[a] + (low[6 * j] - low[6 * i]), y[b] - y[a] + (low[6 * j + 1] - low[6 * i + 1]));
        path.set(
                1,
                x[b + 1] - x[a + 1] + (low[6 * j + 2] - low[6 * i + 2]),
                y[b + 1] - y[a + 1] + (low[6 * j + 3] - low[6 * i + 3]));
        for (int k = 2; k <= order; k++) {
            path.set(k, x[b + k] - x[a + k], y[b + k] - y[a + k]);
        }
    }

    /** Copies the path of a body. */
    void copyPath(int i, DensePath path) {
        path.begin(unit);
        for (int k = 0; k <= order; k++) {
            path.set(k, x[i * stride + k], y[i * stride + k]);
        }
    }

    // --- where it leads ---

    /** Puts all free bodies where they are a time t after the moment of the expansion. */
    void place(Bodies bodies, double t) {
        for (int i = 0; i < count; i++) {
            if (free[i]) {
                place(bodies, i, t / unit);
            }
        }
    }

    private void place(Bodies bodies, int i, double t) {
        int at = i * stride;
        double px = x[at + order];
        double py = y[at + order];
        double vx = order * px;
        double vy = order * py;
        for (int k = order - 1; k > 2; k--) {
            px = px * t + x[at + k];
            py = py * t + y[at + k];
            vx = vx * t + k * x[at + k];
            vy = vy * t + k * y[at + k];
        }
        double t2 = t * t;
        // x0 + t v0 + t² x2 and v0 + t 2 x2 in pairs of doubles, the rest in doubles
        double lowX = low[6 * i] + t * (low[6 * i + 2] + t * (low[6 * i + 4] + t * px));
        double lowY = low[6 * i + 1] + t * (low[6 * i + 3] + t * (low[6 * i + 5] + t * py));
        double lowVx = low[6 * i + 2] + t * (2 * low[6 * i + 4] + t * vx);
        double lowVy = low[6 * i + 3] + t * (2 * low[6 * i + 5] + t * vy);
        along.set(x[at], t, x[at + 1], t2, x[at + 2], lowX);
        across.set(y[at], t, y[at + 1], t2, y[at + 2], lowY);
        bodies.place(i, along.high(), along.low(), across.high(), across.low());
        along.set(x[at + 1], t, 2 * x[at + 2], 0, 0, lowVx);
        across.set(y[at + 1], t, 2 * y[at + 2], 0, 0, lowVy);
        bodies.setVelocity(i, along.high() / unit, along.low() / unit, across.high() / unit, across.low() / unit);
    }
}

package io.github.apsis.benchmarks.steering;

/**
 * Optimal reciprocal collision avoidance (van den Berg, Guy, Lin and Manocha 2011, "Reciprocal n-body collision avoidance", Springer
 * Tracts in Advanced Robotics 70, 3–19): every other takes a half-plane of velocities away, and of what is left the velocity
 * closest to the preferred one is taken.
 *
 * <pre>
 *   obstacle  { v : |t v − p| &lt; r for some t in (0, τ] }        allowed  (w − v − s u) · n ≥ 0
 * </pre>
 *
 * <p>p and r are the place of the other, seen from here, and the distance at which the two touch; u is the shortest way for the relative
 * velocity to leave the obstacle, n points out of it there, and s is the share of that way to take: half of it beside who does the
 * same, all of it otherwise.
 */
final class Orca {
    private static final int HALVINGS = 20; // of the top speed: a millionth of it
    private static final double PARALLEL = 1e-9; // sine of the angle

    private final double top; // speed
    private final double[] x; // a velocity on the edge of each half-plane
    private final double[] y;
    private final double[] nx; // into it
    private final double[] ny;
    private int count;
    private double wishX;
    private double wishY;
    private double bestX;
    private double bestY;

    Orca(double topSpeed, int most) {
        top = topSpeed;
        x = new double[most];
        y = new double[most];
        nx = new double[most];
        ny = new double[most];
    }

    /** Forgets all others. */
    void clear() {
        count = 0;
    }

    /**
     * Takes in another.
     *
     * @param px where it is, relative to where the ship is, as {@code py}
     * @param r distance at which the two touch
     * @param vx velocity of the ship, as {@code vy}
     * @param dvx velocity of the ship relative to the other, as {@code dvy}
     * @param share of the evasion
     * @param time for which not to touch; where the two do already, in which to part
     */
    void keepClear(
            double px, double py, double r, double vx, double vy, double dvx, double dvy, double share, double time) {
        double p2 = px * px + py * py;
        double fromX = dvx - px / time; // from the middle of the disc of velocities that touch exactly then
        double fromY = dvy - py / time;
        double from = length(fromX, fromY);
        double towards = -(fromX * px + fromY * py);
        boolean touching = p2 <= r * r;
        double outX;
        double outY;
        double way;
        if (touching || (towards > 0 && towards > r * from)) { // out through the disc
            outX = from > 0 ? fromX / from : 1;
            outY = from > 0 ? fromY / from : 0;
            way = r / time - from;
        } else { // out through one of the tangents
            double tangent = Math.sqrt(p2 - r * r);
            double side = px * fromY - py * fromX > 0 ? 1 : -1; // 1: the left one
            outX = -(px * r + side * py * tangent) / p2;
            outY = (side * px * tangent - py * r) / p2;
            way = -(dvx * outX + dvy * outY);
        }
        x[count] = vx + share * way * outX;
        y[count] = vy + share * way * outY;
        nx[count] = outX;
        ny[count++] = outY;
    }

    /** Chooses a velocity; where none is in all half-planes, one that is least outside of that it is farthest from. */
    void choose(double preferredX, double preferredY) {
        wishX = preferredX;
        wishY = preferredY;
        if (holds(0)) {
            return;
        }
        double low = 0;
        double high = top;
        while (!holds(high)) {
            high *= 2;
        }
        for (int k = 0; k < HALVINGS; k++) {
            double middle = 0.5 * (low + high);
            if (holds(middle)) {
                high = middle;
            } else {
                low = middle;
            }
        }
        holds(high);
    }

    /** One half-plane after the other (Seidel 1991): where a new one is broken, the best is on its edge. */
    private boolean holds(double slack) {
        double wish = length(wishX, wishY);
        double cut = wish > top ? top / wish : 1;
        bestX = cut * wishX;
        bestY = cut * wishY;
        for (int i = 0; i < count; i++) {
            boolean broken = (bestX - x[i]) * nx[i] + (bestY - y[i]) * ny[i] < -slack;
            if (broken && !moveToEdge(i, slack)) {
                return false;
            }
        }
        return true;
    }

    private boolean moveToEdge(int i, double slack) {
        double ax = x[i] - slack * nx[i];
        double ay = y[i] - slack * ny[i];
        double alongX = -ny[i];
        double alongY = nx[i];
        double middle = -(ax * alongX + ay * alongY);
        double off = ax * nx[i] + ay * ny[i];
        if (Math.abs(off) > top) {
            return false;
        }
        double half = Math.sqrt(top * top - off * off);
        double from = middle - half;
        double to = middle + half;
        for (int j = 0; j < i; j++) {
            double rate = alongX * nx[j] + alongY * ny[j];
            double inside = (ax - x[j]) * nx[j] + (ay - y[j]) * ny[j] + slack;
            if (rate > PARALLEL) {
                from = Math.max(from, -inside / rate);
            } else if (rate < -PARALLEL) {
                to = Math.min(to, -inside / rate);
            } else if (inside < 0) {
                return false;
            }
        }
        if (from > to) {
            return false;
        }
        double best = Math.max(from, Math.min(to, (wishX - ax) * alongX + (wishY - ay) * alongY));
        bestX = ax + best * alongX;
        bestY = ay + best * alongY;
        return true;
    }

    private static double length(double dx, double dy) {
        return Math.sqrt(dx * dx + dy * dy);
    }

    double x() {
        return bestX;
    }

    double y() {
        return bestY;
    }
}

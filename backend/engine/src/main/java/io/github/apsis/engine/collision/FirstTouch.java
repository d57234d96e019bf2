package io.github.apsis.engine.collision;

/**
 * When two circles first touch on the parabola of {@link TimeOfImpact}, by the search of {@link ClosingGap}: none is overlooked,
 * neither one that the chord passes by nor the next one of a ball that leaves and returns.
 */
final class FirstTouch {
    private FirstTouch() {}

    /** The time of the first touch, {@code t0} for circles that touch already and approach, NaN for none. */
    static double ofCircles(
            double d0x,
            double d0y,
            double d1x,
            double d1y,
            double bx,
            double by,
            double t0,
            double t1,
            double sumOfRadii) {
        double wx = (d1x - d0x) / (t1 - t0);
        double wy = (d1y - d0y) / (t1 - t0);
        double acceleration = Math.sqrt(bx * bx + by * by);
        double t = t0;
        for (int look = 0; look < ClosingGap.MOST_LOOKS; look++) {
            double bend = 0.5 * (t - t0) * (t1 - t);
            double slope = 0.5 * (t0 + t1) - t; // derivative of the bend
            double dx = d0x + wx * (t - t0) - bx * bend;
            double dy = d0y + wy * (t - t0) - by * bend;
            double distance = Math.sqrt(dx * dx + dy * dy);
            if (distance == 0) {
                return t;
            }
            double rate = (dx * (wx - bx * slope) + dy * (wy - by * slope)) / distance;
            double next = ClosingGap.next(t, distance - sumOfRadii, rate, acceleration, sumOfRadii);
            if (!(next <= t1)) {
                return Double.NaN;
            }
            if (next == t) {
                return t;
            }
            t = next;
        }
        return t;
    }

    /**
     * The same for a distance along one axis, zero at the touch: a circle and a wall.
     *
     * @param size that the gap is a difference of, length
     */
    static double ofWall(double gap0, double gap1, double b, double t0, double t1, double size) {
        double w = (gap1 - gap0) / (t1 - t0);
        double acceleration = Math.max(0, -b);
        double t = t0;
        for (int look = 0; look < ClosingGap.MOST_LOOKS; look++) {
            double gap = gap0 + w * (t - t0) - 0.5 * b * (t - t0) * (t1 - t);
            double rate = w - b * (0.5 * (t0 + t1) - t);
            double next = ClosingGap.next(t, gap, rate, acceleration, size);
            if (!(next <= t1)) {
                return Double.NaN;
            }
            if (next == t) {
                return t;
            }
            t = next;
        }
        return t;
    }
}

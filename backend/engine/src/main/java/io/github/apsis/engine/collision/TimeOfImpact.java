package io.github.apsis.engine.collision;

/**
 * When two circles first touch within a tick.
 *
 * <p>The distance vector moves on the parabola through its two ends,
 *
 * <pre>
 *   d(t) = d0 + (d1 − d0) (t − t0)/(t1 − t0) − b (t − t0)(t1 − t)/2,      |d(t)| = R
 * </pre>
 *
 * with b the relative acceleration. The chord gives the first guess in closed form (Ericson 2005, Real-Time Collision
 * Detection, section 5.5.5), Newton's method the rest; without acceleration the chord is the answer.
 */
final class TimeOfImpact {
    /** Newton converges quadratically from a guess wrong by b (t1 − t0)² / 8 at most: three steps reach rounding. */
    private static final int NEWTON_STEPS = 3;

    private TimeOfImpact() {}

    /**
     * Where on the chord the circles touch first, as a share of it; NaN where they never do. They are apart at its beginning:
     * {@code outside} = |d0|² − R² is positive.
     */
    static double onChord(double d0x, double d0y, double wx, double wy, double outside, double sumOfRadii) {
        double closing = d0x * wx + d0y * wy;
        double w2 = wx * wx + wy * wy;
        // closing² − w² outside, written so that a fast body and a small target keep their digits.
        double cross = d0x * wy - d0y * wx;
        double discriminant = w2 * sumOfRadii * sumOfRadii - cross * cross;
        if (closing >= 0 || discriminant < 0) {
            return Double.NaN;
        }
        double share = outside / (-closing + Math.sqrt(discriminant)); // the earlier root, without cancellation
        return share > 1 ? Double.NaN : share;
    }

    /** Whether circles that move on a chord touch, or touched already at its beginning, or would if it went on. */
    static boolean mayTouch(double d0x, double d0y, double wx, double wy, double sumOfRadii) {
        double closing = d0x * wx + d0y * wy;
        double w2 = wx * wx + wy * wy;
        double cross = d0x * wy - d0y * wx;
        return d0x * d0x + d0y * d0y <= sumOfRadii * sumOfRadii
                | closing < 0 & w2 * sumOfRadii * sumOfRadii >= cross * cross;
    }

    /** The time of the touch on the parabola, from that on its chord. */
    static double onParabola(
            double share,
            double d0x,
            double d0y,
            double wx,
            double wy,
            double bx,
            double by,
            double t0,
            double t1,
            double sumOfRadii) {
        double length = t1 - t0;
        double t = t0 + share * length;
        if (bx == 0 && by == 0) {
            return t;
        }
        for (int step = 0; step < NEWTON_STEPS; step++) {
            double s = (t - t0) / length;
            double bend = 0.5 * (t - t0) * (t1 - t);
            double dx = d0x + wx * s - bx * bend;
            double dy = d0y + wy * s - by * bend;
            double slope = 0.5 * (t0 + t1) - t; // derivative of the bend
            double rate = dx * (wx / length - bx * slope) + dy * (wy / length - by * slope);
            if (rate >= 0) {
                break; // the parabola only grazes: stay with the chord
            }
            double excess = 0.5 * (dx * dx + dy * dy - sumOfRadii * sumOfRadii);
            t = Math.min(t1, Math.max(t0, t - excess / rate));
        }
        return t;
    }

    /** The time of the first touch of a circle and a wall, whose distance is along one axis and zero at the touch; NaN for none. */
    static double ofWall(double gap0, double gap1, double v0, double b, double t0, double t1) {
        double length = t1 - t0;
        double w = gap1 - gap0;
        if (gap0 <= 0) {
            return v0 < 0 ? t0 : Double.NaN;
        }
        if (gap1 > 0) {
            return Double.NaN;
        }
        double t = t0 + length * gap0 / (gap0 - gap1);
        for (int step = 0; step < NEWTON_STEPS && b != 0; step++) {
            double gap = gap0 + w * (t - t0) / length - 0.5 * b * (t - t0) * (t1 - t);
            double rate = w / length - b * (0.5 * (t0 + t1) - t);
            if (rate >= 0) {
                break;
            }
            t = Math.min(t1, Math.max(t0, t - gap / rate));
        }
        return t;
    }
}

package io.github.apsis.engine.collision;

/**
 * The search for the moment at which a gap closes first, which no path can slip through.
 *
 * <p>The distance of two points never bends inwards more than their relative acceleration, |d|'' ≥ −|d''|, and no more does a
 * distance from a wall. So a gap g that changes at the rate g' stays open, while the acceleration is below A, for
 *
 * <pre>
 *   s = 2 g / (−g' + √(g'² + 2 A g))
 * </pre>
 *
 * <p>A search goes forward by such steps: never beyond the first contact, and towards it as fast as Newton's method, which s
 * becomes for A = 0.
 */
public final class ClosingGap {
    /** After so many steps a search has come close to something that it hardly meets. */
    public static final int MOST_LOOKS = 100;

    /** A gap below this share of what it is measured on is closed: rounding. */
    private static final double CLOSED = 1e-15;

    private ClosingGap() {}

    /**
     * The time until which a search may go on from t; t itself where it has arrived. Partners that touch and separate are let go,
     * partners that touch and close have arrived.
     *
     * @param size that the gap is a difference of, length
     */
    public static double next(double t, double gap, double rate, double acceleration, double size) {
        if (gap <= CLOSED * size) {
            return rate < 0 ? t : t + safeTime(0, rate, acceleration);
        }
        return t + safeTime(gap, rate, acceleration);
    }

    /** How long a gap stays open for certain, s. */
    static double safeTime(double gap, double rate, double acceleration) {
        double root = Math.sqrt(rate * rate + 2 * acceleration * gap);
        if (rate > 0) {
            return (rate + root) / acceleration;
        }
        if (root == rate) {
            return acceleration > 0 ? 0 : Double.POSITIVE_INFINITY; // touching, and neither closing nor separating
        }
        return 2 * gap / (root - rate);
    }
}

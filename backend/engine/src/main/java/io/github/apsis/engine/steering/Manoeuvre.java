package io.github.apsis.engine.steering;

/**
 * The way of a ship from one velocity to another: a constant acceleration for as long as it takes, then straight on.
 *
 * <pre>
 *   s(t) = v t + Δv t²/2T   until T,   w t − Δv T/2   afterwards      T = Δv/a + a τ²/Δv,   and 2τ where Δv &lt; a τ
 * </pre>
 *
 * <p>T is longer than Δv/a because a ship closes in on its course with the time constant τ: it then lags behind by as much as
 * one that accelerates for T.
 */
final class Manoeuvre {
    private Manoeuvre() {}

    /** How long it takes, for a change of velocity, an acceleration and a time constant. */
    static double duration(double change, double a, double lag) {
        if (change < a * lag) {
            return 2 * lag;
        }
        return change == 0 ? 0 : change / a + a * lag * lag / change;
    }

    /** One coordinate of the distance covered by time {@code t}. */
    static double at(double t, double from, double to, double duration) {
        return t < duration ? from * t + 0.5 * (to - from) * t * t / duration : to * t - 0.5 * (to - from) * duration;
    }
}

package io.github.apsis.benchmarks.contacts;

import io.github.apsis.engine.diagnostics.Conserved;

/**
 * The momentum of a run beyond what walls and fields gave, by the books of the world.
 *
 * <pre>
 *   max over the ticks |p(t) − p(0) − J(t)| / (max over the ticks Σ m |v| + Σ m |g| T)
 * </pre>
 *
 * <p>The scale is of the whole run: a ball at the top of its flight has no momentum to compare with, and what a uniform field g
 * gives in all the time T is rounded as it is given, however much of it the walls take back.
 */
final class MomentumBalance {
    private final Conserved start;
    private final double fieldImpulse;
    private double worst; // mass · length / time
    private double scale;

    /**
     * From a start.
     *
     * @param fieldImpulse Σ m |g| T, mass · length / time
     */
    MomentumBalance(Conserved start, double fieldImpulse) {
        this.start = start;
        this.fieldImpulse = fieldImpulse;
        this.scale = start.momentumScale();
    }

    void tick(Conserved now) {
        double dx = now.momentumX()
                - start.momentumX()
                - (now.booked().momentumX() - start.booked().momentumX());
        double dy = now.momentumY()
                - start.momentumY()
                - (now.booked().momentumY() - start.booked().momentumY());
        double off = Math.hypot(dx, dy);
        worst = Double.isNaN(off) ? Double.POSITIVE_INFINITY : Math.max(worst, off);
        scale = Math.max(scale, now.momentumScale());
    }

    double error() {
        return worst == 0 ? 0 : worst / (scale + fieldImpulse);
    }
}

package io.github.apsis.engine.collision;

/** How exactly contacts are told from rest. */
public enum ContactMode {
    /** For crowds: what closes no faster than the forces push in two ticks lies at rest. */
    TICK(2),
    /** For elastic gases, cradles, billiards and bouncing balls: at rest is what would fly for less than a thousandth of a tick. */
    EXACT(0.5e-3);

    private final double restingTicks;

    ContactMode(double restingTicks) {
        this.restingTicks = restingTicks;
    }

    /** A contact at rest closes no faster than forces push in so many ticks. */
    double restingTicks() {
        return restingTicks;
    }
}

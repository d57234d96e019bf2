package io.github.apsis.server.room;

import io.github.apsis.engine.World;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.diagnostics.Drift;
import org.jspecify.annotations.Nullable;

/**
 * Measures what a running world keeps, against the moment at which its bodies were last changed. Belongs to the tick
 * thread.
 */
final class ConservationMeter {
    /**
     * The sum over pairs costs n²/2: half a millisecond for this many bodies, a tenth of a tick, four times a second.
     */
    static final int MOST_BODIES = 500;

    private @Nullable Conserved baseline;

    /** The bodies have changed: drift counts from the next measurement. */
    void reset() {
        baseline = null;
    }

    Conservation measure(World world) {
        Conserved now = world.conserved();
        if (baseline == null) {
            baseline = now;
        }
        return new Conservation(now, Drift.between(baseline, now));
    }
}

package io.github.apsis.server.room;

import io.github.apsis.engine.World;
import io.github.apsis.engine.body.Ledger;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.math.Vec2;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;

/**
 * Measures what a running world keeps, against the moment at which its bodies were last changed. Belongs to the tick
 * thread.
 *
 * <pre>
 *   energy drift   = (E − E₀ − W) / (K₀ + |U₀| + |W|)     W: work that the ledger has booked since
 *   momentum drift = |p − p₀ − J| / Σ|m·v|          J: impulses that it has booked since
 * </pre>
 */
final class ConservationMeter {
    /**
     * The sum over pairs costs n²/2: half a millisecond for this many bodies, a tenth of a tick, four times a second.
     */
    static final int MOST_BODIES = 500;

    private @Nullable Baseline baseline;

    private record Baseline(Conserved conserved, double work, double impulseX, double impulseY) {
        static Baseline of(Conserved conserved, Ledger ledger) {
            return new Baseline(conserved, ledger.energy(), ledger.momentumX(), ledger.momentumY());
        }
    }

    /** The bodies have changed: drift counts from the next measurement. */
    void reset() {
        baseline = null;
    }

    Conservation measure(World world) {
        Conserved now = world.conserved();
        if (baseline == null) {
            baseline = Baseline.of(now, world.ledger());
        }
        return new Conservation(
                now.energy(),
                energyDrift(baseline, now, world.ledger()),
                new Vec2(now.momentumX(), now.momentumY()),
                momentumDrift(baseline, now, world.ledger()));
    }

    private static OptionalDouble energyDrift(Baseline then, Conserved now, Ledger ledger) {
        if (now.energy().isEmpty() || then.conserved.energy().isEmpty()) {
            return OptionalDouble.empty();
        }
        double work = ledger.energy() - then.work;
        double error = now.energy().getAsDouble() - then.conserved.energy().getAsDouble() - work;
        double scale =
                then.conserved.kinetic() + Math.abs(then.conserved.potential().orElse(0)) + Math.abs(work);
        return OptionalDouble.of(share(error, scale));
    }

    private static double momentumDrift(Baseline then, Conserved now, Ledger ledger) {
        double errorX = now.momentumX() - then.conserved.momentumX() - (ledger.momentumX() - then.impulseX);
        double errorY = now.momentumY() - then.conserved.momentumY() - (ledger.momentumY() - then.impulseY);
        return share(Math.hypot(errorX, errorY), Math.max(now.momentumScale(), then.conserved.momentumScale()));
    }

    private static double share(double error, double scale) {
        return scale == 0 ? 0 : error / scale;
    }
}

package io.github.apsis.engine.diagnostics;

import java.util.OptionalDouble;

/**
 * How far a world has strayed, between two measurements, from what it should have kept. What engines, contacts, walls and
 * fields did is {@link Booked}; the rest is the error of the numerics.
 *
 * <pre>
 *   energy            (E − E₀ − W) / (K₀ + |U₀| + |W|)
 *   momentum          |p − p₀ − J| / max(Σ m|v|, Σ m|v₀|)
 *   angular momentum  (L − L₀ − M) / max(Σ m|r||v|, Σ m|r₀||v₀|)
 * </pre>
 *
 * <p>with the work W, the impulse J and the moment M booked between. Bodies that were added, removed or left in between count
 * as error: measure anew after such a change.
 *
 * @param energy empty when a force law has no potential
 * @param momentum a share of all momentum that is under way
 * @param angularMomentum a share of all that is under way; empty in a world that repeats itself, and without mass
 */
public record Drift(OptionalDouble energy, double momentum, OptionalDouble angularMomentum) {
    /** What went astray from {@code then} to {@code now}, two measurements of the same world. */
    public static Drift between(Conserved then, Conserved now) {
        return new Drift(energy(then, now), momentum(then, now), angularMomentum(then, now));
    }

    private static OptionalDouble energy(Conserved then, Conserved now) {
        if (then.energy().isEmpty() || now.energy().isEmpty()) {
            return OptionalDouble.empty();
        }
        double work = now.booked().energy() - then.booked().energy();
        double error = now.energy().getAsDouble() - then.energy().getAsDouble() - work;
        return OptionalDouble.of(
                share(error, then.kinetic() + Math.abs(then.potential().orElse(0)) + Math.abs(work)));
    }

    private static double momentum(Conserved then, Conserved now) {
        double dx = now.momentumX()
                - then.momentumX()
                - (now.booked().momentumX() - then.booked().momentumX());
        double dy = now.momentumY()
                - then.momentumY()
                - (now.booked().momentumY() - then.booked().momentumY());
        return share(Math.sqrt(dx * dx + dy * dy), Math.max(then.momentumScale(), now.momentumScale()));
    }

    private static OptionalDouble angularMomentum(Conserved then, Conserved now) {
        if (then.centreOfMass().isEmpty() || now.centreOfMass().isEmpty()) {
            return OptionalDouble.empty();
        }
        double moment = now.booked().angularMomentum() - then.booked().angularMomentum();
        double error = now.angularMomentum() - then.angularMomentum() - moment;
        return OptionalDouble.of(share(error, Math.max(then.angularMomentumScale(), now.angularMomentumScale())));
    }

    /** A world in which nothing moves has nothing to lose; one beyond the numbers has lost everything. */
    private static double share(double error, double scale) {
        double share = error == 0 ? 0 : error / scale;
        return Double.isNaN(share) ? Double.POSITIVE_INFINITY : share;
    }
}

package io.github.apsis.benchmarks;

import io.github.apsis.engine.World;
import io.github.apsis.engine.body.Ledger;
import io.github.apsis.engine.diagnostics.Conserved;
import java.util.OptionalDouble;

/**
 * How far a world has strayed from what it should have kept. What engines, contacts and walls did is in the books of its
 * {@link Ledger}; the rest is the error of the numerics.
 *
 * <pre>
 *   energy    (E − E0 − W) / (K0 + |U0| + |W|)          W: work that the ledger has booked
 *   momentum  |P − P0 − J| / max(Σ m|v|, Σ m|v0|)      J: impulses that it has booked
 * </pre>
 *
 * @param energy empty when a force law has no potential
 * @param momentum a share of all momentum that is under way
 */
public record Drift(OptionalDouble energy, double momentum) {
    /** Measures against the state in which the world began, when its books were empty. */
    public static Drift since(Conserved start, World world) {
        Conserved now = world.conserved();
        Ledger booked = world.ledger();
        return new Drift(energy(start, now, booked), momentum(start, now, booked));
    }

    private static OptionalDouble energy(Conserved start, Conserved now, Ledger booked) {
        if (start.energy().isEmpty() || now.energy().isEmpty()) {
            return OptionalDouble.empty();
        }
        double change = now.energy().getAsDouble() - start.energy().getAsDouble() - booked.energy();
        double scale = start.kinetic() + Math.abs(start.potential().orElse(0)) + Math.abs(booked.energy());
        return OptionalDouble.of(ratio(change, scale));
    }

    private static double momentum(Conserved start, Conserved now, Ledger booked) {
        double dx = now.momentumX() - start.momentumX() - booked.momentumX();
        double dy = now.momentumY() - start.momentumY() - booked.momentumY();
        return ratio(Math.sqrt(dx * dx + dy * dy), Math.max(start.momentumScale(), now.momentumScale()));
    }

    /** A world in which nothing moves has nothing to lose. */
    private static double ratio(double change, double scale) {
        return change == 0 ? 0 : change / scale;
    }
}

package io.github.apsis.engine.diagnostics;

import io.github.apsis.engine.body.Ledger;

/** The sums of a {@link Ledger} at one moment: what came into a world by right since it began. */
public record Booked(double energy, double momentumX, double momentumY, double angularMomentum) {
    static Booked of(Ledger ledger) {
        return new Booked(ledger.energy(), ledger.momentumX(), ledger.momentumY(), ledger.angularMomentum());
    }
}

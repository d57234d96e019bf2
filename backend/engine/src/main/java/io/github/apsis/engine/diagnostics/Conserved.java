package io.github.apsis.engine.diagnostics;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.force.Forces;
import io.github.apsis.engine.math.CompensatedSum;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.math.Vec2;
import java.util.Optional;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;

/**
 * The quantities that an undisturbed world keeps, summed with compensation so that the measurement is not the error, and what
 * disturbed it so far. Two of them tell the {@link Drift} between.
 *
 * @param kinetic Σ m v² / 2 over free bodies
 * @param potential of all forces; empty when a force law has none
 * @param momentumX Σ m vx
 * @param momentumY Σ m vy
 * @param momentumScale Σ m |v|, what a momentum error is measured against
 * @param angularMomentum Σ m (x vy − y vx) about the origin
 * @param angularMomentumScale Σ m |r| |v|, what its error is measured against
 * @param centreOfMass Σ m r / Σ m over all bodies; empty without mass, and in a world that repeats itself, where a place is
 *     known only up to a period and angular momentum jumps with it
 * @param coincidentPairs pairs in the same place, which do not pull each other
 * @param booked what came in by right since the world began
 */
public record Conserved(
        double kinetic,
        OptionalDouble potential,
        double momentumX,
        double momentumY,
        double momentumScale,
        double angularMomentum,
        double angularMomentumScale,
        Optional<Vec2> centreOfMass,
        long coincidentPairs,
        Booked booked) {

    /** Measures the present state. Costs as much as one evaluation of the forces. */
    public static Conserved of(Bodies bodies, Forces forces, @Nullable Period period) {
        var kinetic = new CompensatedSum();
        var px = new CompensatedSum();
        var py = new CompensatedSum();
        var scale = new CompensatedSum();
        var spin = new CompensatedSum();
        var spinScale = new CompensatedSum();
        for (int i = 0; i < bodies.count(); i++) {
            double m = bodies.mass(i);
            double vx = bodies.vx(i);
            double vy = bodies.vy(i);
            double speed = Math.sqrt(vx * vx + vy * vy);
            kinetic.add(0.5 * m * (vx * vx + vy * vy));
            px.add(m * vx);
            py.add(m * vy);
            scale.add(m * speed);
            spin.add(m * (bodies.x(i) * vy - bodies.y(i) * vx));
            spinScale.add(m * speed * Math.sqrt(bodies.x(i) * bodies.x(i) + bodies.y(i) * bodies.y(i)));
        }
        return new Conserved(
                kinetic.value(),
                forces.potential(bodies),
                px.value(),
                py.value(),
                scale.value(),
                spin.value(),
                spinScale.value(),
                period == null ? centreOfMass(bodies) : Optional.empty(),
                CoincidentPairs.count(bodies),
                Booked.of(bodies.ledger()));
    }

    private static Optional<Vec2> centreOfMass(Bodies bodies) {
        var mass = new CompensatedSum();
        var mx = new CompensatedSum();
        var my = new CompensatedSum();
        for (int i = 0; i < bodies.count(); i++) {
            mass.add(bodies.mass(i));
            mx.add(bodies.mass(i) * bodies.x(i));
            my.add(bodies.mass(i) * bodies.y(i));
        }
        double total = mass.value();
        return total > 0 ? Optional.of(new Vec2(mx.value() / total, my.value() / total)) : Optional.empty();
    }

    /** Kinetic + potential energy; empty when a force law has no potential, or the energy is no finite number. */
    public OptionalDouble energy() {
        double energy = kinetic + potential.orElse(Double.NaN);
        return Double.isFinite(energy) ? OptionalDouble.of(energy) : OptionalDouble.empty();
    }

    /**
     * 2 K / |U|: 1 in a cluster that keeps its size in the long run (the virial theorem of Clausius 1870), less where it falls
     * together, more than 2 where it flies apart. Empty without potential.
     */
    public OptionalDouble virialRatio() {
        double ratio = 2 * kinetic / Math.abs(potential.orElse(0));
        return Double.isFinite(ratio) ? OptionalDouble.of(ratio) : OptionalDouble.empty();
    }
}

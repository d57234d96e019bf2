package io.github.apsis.engine.diagnostics;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.force.Forces;
import io.github.apsis.engine.math.CompensatedSum;
import java.util.OptionalDouble;

/**
 * The quantities that an undisturbed world keeps, summed with compensation so that the measurement is not the error.
 *
 * @param kinetic Σ m v² / 2 over free bodies
 * @param potential of all forces; empty when a force law has none
 * @param momentumX Σ m vx
 * @param momentumY Σ m vy
 * @param momentumScale Σ m |v|, what a momentum error is measured against
 * @param angularMomentum Σ m (x vy − y vx) about the origin
 */
public record Conserved(
        double kinetic,
        OptionalDouble potential,
        double momentumX,
        double momentumY,
        double momentumScale,
        double angularMomentum) {

    /** Measures the present state. Costs as much as one evaluation of the forces. */
    public static Conserved of(Bodies bodies, Forces forces) {
        var kinetic = new CompensatedSum();
        var px = new CompensatedSum();
        var py = new CompensatedSum();
        var scale = new CompensatedSum();
        var spin = new CompensatedSum();
        for (int i = 0; i < bodies.count(); i++) {
            double m = bodies.mass(i);
            double vx = bodies.vx(i);
            double vy = bodies.vy(i);
            kinetic.add(0.5 * m * (vx * vx + vy * vy));
            px.add(m * vx);
            py.add(m * vy);
            scale.add(m * Math.sqrt(vx * vx + vy * vy));
            spin.add(m * (bodies.x(i) * vy - bodies.y(i) * vx));
        }
        return new Conserved(
                kinetic.value(), forces.potential(bodies), px.value(), py.value(), scale.value(), spin.value());
    }

    /** Kinetic + potential energy; empty when a force law has no potential. */
    public OptionalDouble energy() {
        return potential.isPresent() ? OptionalDouble.of(kinetic + potential.getAsDouble()) : OptionalDouble.empty();
    }
}

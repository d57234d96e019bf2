package io.github.apsis.engine.diagnostics;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.force.ForceLaw;
import io.github.apsis.engine.force.GravitySample;

/**
 * Relative errors |Δa| / |a| of a gravity solver at the present positions, over a sample of the bodies.
 *
 * @param median of the sample
 * @param ninetieth what nine of ten do not exceed
 * @param worst of the sample; large where pulls nearly cancel
 */
public record ForceError(double median, double ninetieth, double worst) {
    /** Measures a law against the compensated direct sum; works on a copy and changes nothing. */
    public static ForceError of(Bodies bodies, ForceLaw gravity, double g, double softening) {
        var copy = new Bodies();
        for (int i = 0; i < bodies.count(); i++) {
            copy.add(BodyDef.planet(bodies.x(i), bodies.y(i), bodies.mass(i), 0));
        }
        gravity.apply(copy);
        var sample = new GravitySample(g, softening);
        sample.take(copy);
        for (int i = 0; i < copy.count(); i++) {
            sample.accelerate(i, copy.ax(i), copy.ay(i));
        }
        sample.compare();
        return new ForceError(sample.error(0.5), sample.error(0.9), sample.error(1));
    }
}

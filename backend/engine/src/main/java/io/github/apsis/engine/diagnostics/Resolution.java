package io.github.apsis.engine.diagnostics;

import io.github.apsis.engine.body.Bodies;

/**
 * Whether doubles are fine enough for the places where bodies are: the spacing of doubles at a body, as a share of the way it
 * goes in one tick.
 *
 * <pre>
 *   max over bodies of   ulp(max(|x|, |y|)) / (|v| dt)
 * </pre>
 *
 * <p>1e-12 is usual. From about 1e-3 on paths are more rounding than physics, and above 1 a body stands still for whole ticks:
 * put the origin nearer. Bodies slower than a millionth of the fastest count as at rest.
 */
public final class Resolution {
    private static final double AT_REST = 1e-6; // of the fastest

    private Resolution() {}

    /** The worst share; 0 where nothing moves. */
    public static double of(Bodies bodies, double dt) {
        double fastest = 0;
        for (int i = 0; i < bodies.count(); i++) {
            fastest = Math.max(fastest, speed(bodies, i));
        }
        double worst = 0;
        for (int i = 0; i < bodies.count(); i++) {
            double way = speed(bodies, i) * dt;
            if (way > AT_REST * fastest * dt) {
                worst = Math.max(worst, Math.ulp(Math.max(Math.abs(bodies.x(i)), Math.abs(bodies.y(i)))) / way);
            }
        }
        return worst;
    }

    private static double speed(Bodies bodies, int i) {
        return Math.sqrt(bodies.vx(i) * bodies.vx(i) + bodies.vy(i) * bodies.vy(i));
    }
}

package io.github.apsis.server.room;

import io.github.apsis.scenes.Look;
import io.github.apsis.scenes.shape.Outline;

/**
 * How a body looks since it was born.
 *
 * @param bornAt simulated time
 */
public record Appearance(Look look, double bornAt) {
    public Outline outline() {
        return look.outline();
    }

    /** How far the outline has turned, radians, 0 to 2π. */
    public double angleAt(double time) {
        return look.angleAfter(time - bornAt);
    }
}

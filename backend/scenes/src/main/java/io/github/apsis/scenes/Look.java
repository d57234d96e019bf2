package io.github.apsis.scenes;

import io.github.apsis.scenes.shape.Outline;

/**
 * How a body looks beyond its circle. The physics never reads it: a spin turns what is drawn.
 *
 * @param outline the shape at angle 0
 * @param angle radians at the tick in which the body is born
 * @param spin radians / time
 */
public record Look(Outline outline, double angle, double spin) {
    /** The angle, 0 to 2π, after some time. */
    public double angleAfter(double time) {
        double turns = (angle + spin * time) / (2 * Math.PI);
        return (turns - Math.floor(turns)) * 2 * Math.PI;
    }
}

package io.github.apsis.scenes;

import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;

/**
 * What the random bodies of a scene are like, in its units.
 *
 * @param area where they are placed
 * @param planetRadius smallest and largest
 * @param planetDensity smallest and largest, mass / area
 * @param asteroidRadius smallest and largest
 * @param asteroidDensity mass / area of the outline
 * @param asteroidSpeed largest speed at birth
 * @param asteroidSpin largest spin, radians / time
 * @param shipRadius of every ship
 * @param shipMass of every ship
 * @param shipLimits of every ship
 */
public record Palette(
        Aabb area,
        Range planetRadius,
        Range planetDensity,
        Range asteroidRadius,
        double asteroidDensity,
        double asteroidSpeed,
        double asteroidSpin,
        double shipRadius,
        double shipMass,
        ShipLimits shipLimits) {

    /** From … to, both positive. */
    public record Range(double from, double to) {
        public Range {
            if (!(from > 0 && from <= to)) {
                throw new IllegalArgumentException("a range needs 0 < from <= to, was " + from + " to " + to);
            }
        }
    }
}

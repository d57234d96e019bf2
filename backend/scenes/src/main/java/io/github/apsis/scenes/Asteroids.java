package io.github.apsis.scenes;

import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Rng;
import io.github.apsis.scenes.shape.AsteroidOutline;
import io.github.apsis.scenes.shape.Outline;

/** Random asteroids: an outline, and a mass that follows from it. */
final class Asteroids {
    private Asteroids() {}

    /**
     * An asteroid at rest at the origin. Its mass is the area of its outline times the density.
     *
     * @param radius of the bounding circle, length
     * @param density mass / area
     * @param fastestSpin either way, radians / time
     */
    static SceneBody random(Rng rng, double radius, double density, double fastestSpin) {
        Outline outline = AsteroidOutline.random(rng, radius);
        double angle = rng.between(0, 2 * Math.PI);
        double spin = rng.between(-fastestSpin, fastestSpin);
        double mass = AsteroidOutline.area(outline) * density;
        return new SceneBody(BodyDef.asteroid(0, 0, mass, radius), new Look(outline, angle, spin));
    }
}

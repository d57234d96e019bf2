package io.github.apsis.scenes;

import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.scenes.Palette.Range;
import java.util.List;

/**
 * A planet of three and a planet of one part on the Kepler ellipse of eccentricity 1/2, about their centre of mass, which
 * is at rest at the origin. They start at periapsis, on the x axis, and are there again after 10 s.
 *
 * <pre>
 *   G · (m1 + m2) = 4π² a³ / T²          Kepler's third law
 *   r = a (1 − e),   v = √(G (m1 + m2) / a · (1 + e) / (1 − e))          relative, at periapsis
 * </pre>
 */
final class TwoBodies implements Scene {
    static final double PERIOD = 10; // s
    static final double SEMI_MAJOR_AXIS = 200; // u
    static final double ECCENTRICITY = 0.5;
    private static final int MOST_BODIES = 100; // as many pairs as an adaptive tick has time for
    private static final double HEAVY = 3000;
    private static final double LIGHT = 1000;
    private static final double TOTAL = HEAVY + LIGHT;
    private static final double G =
            4 * Math.PI * Math.PI * SEMI_MAJOR_AXIS * SEMI_MAJOR_AXIS * SEMI_MAJOR_AXIS / (PERIOD * PERIOD * TOTAL);

    @Override
    public String name() {
        return "two-bodies";
    }

    @Override
    public String title() {
        return "Two bodies";
    }

    @Override
    public Units units() {
        return new Units("u", "kg", "s");
    }

    @Override
    public Aabb view() {
        return Aabb.centred(300, 240);
    }

    @Override
    public Measures measures() {
        return Measures.ENERGY_AND_MOMENTUM;
    }

    /** The two never touch; contacts are for what people add. */
    @Override
    public WorldSpec spec(long seed) {
        return WorldSpec.builder()
                .gravity(G)
                .contacts(0.8)
                .adaptive(1e-16)
                .maxBodies(MOST_BODIES)
                .seed(seed)
                .build();
    }

    @Override
    public List<SceneBody> bodies(long seed) {
        double distance = SEMI_MAJOR_AXIS * (1 - ECCENTRICITY);
        double speed = Math.sqrt(G * TOTAL / SEMI_MAJOR_AXIS * (1 + ECCENTRICITY) / (1 - ECCENTRICITY));
        double heavyShare = LIGHT / TOTAL;
        double lightShare = HEAVY / TOTAL;
        BodyDef heavy = BodyDef.planet(-distance * heavyShare, 0, HEAVY, 22).moving(0, -speed * heavyShare);
        BodyDef light = BodyDef.planet(distance * lightShare, 0, LIGHT, 13).moving(0, speed * lightShare);
        return List.of(SceneBody.plain(heavy), SceneBody.plain(light));
    }

    @Override
    public Palette palette() {
        return new Palette(
                view(),
                new Range(5, 10),
                new Range(0.5, 2),
                new Range(3, 8),
                0.02,
                120,
                1.5,
                6,
                2,
                new ShipLimits(200, 1200));
    }
}

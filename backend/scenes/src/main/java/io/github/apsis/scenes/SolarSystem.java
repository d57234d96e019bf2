package io.github.apsis.scenes;

import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.scenes.Palette.Range;
import java.util.ArrayList;
import java.util.List;

/**
 * The Sun and its eight planets at J2000 (2000 January 1, 12:00 TDB), in astronomical units, days and solar masses, with
 * G = k² = 0.01720209895² AU³ / (M☉ · day²), the Gaussian constant squared.
 *
 * <ul>
 *   <li>Orbits: Standish and Williams, JPL, "Keplerian Elements for Approximate Positions of the Major Planets", table 1
 *       (1800 to 2050). The plane is the ecliptic; inclinations, 7° at most, are dropped, longitudes of perihelia kept.
 *   <li>Masses: GM of Sun and planetary systems in DE440, Park et al. (2021), AJ 161, 105, table 2. The Earth is the Earth-Moon system.
 *   <li>Radii: IAU, Archinal et al. (2018), Celest. Mech. Dyn. Astron. 130, 22; volumetric means.
 * </ul>
 *
 * <p>The centre of mass is at rest at the origin. A tick is a tenth of a day: at 150 ticks a second Mercury goes round
 * in 6 s and the Earth in 24. Integrated adaptively: the energy stays within 1e-15 for a thousand years, after which the
 * planets are where REBOUND's IAS15 puts them to 2e-10 AU (docs/accuracy).
 */
final class SolarSystem implements Scene {
    static final double G = 0.01720209895 * 0.01720209895;
    private static final int MOST_BODIES = 100; // as many pairs as an adaptive tick has time for
    private static final double KM = 1 / 149_597_870.7; // AU
    private static final double SUN_GM = 132_712_440_041.279419; // km³/s²
    private static final double SUN_RADIUS = 695_700 * KM;

    /** A planet of the tables: GM in km³/s², radius in km. */
    record Planet(String name, double gm, double radiusKm, KeplerOrbit orbit) {
        double mass() {
            return gm / SUN_GM;
        }
    }

    static final List<Planet> PLANETS = List.of(
            new Planet(
                    "Mercury",
                    22_031.868551,
                    2_439.4,
                    new KeplerOrbit(0.38709927, 0.20563593, 252.25032350, 77.45779628)),
            new Planet(
                    "Venus", 324_858.592, 6_051.8, new KeplerOrbit(0.72333566, 0.00677672, 181.97909950, 131.60246718)),
            new Planet(
                    "Earth",
                    403_503.235625,
                    6_371.0084,
                    new KeplerOrbit(1.00000261, 0.01671123, 100.46457166, 102.93768193)),
            new Planet(
                    "Mars", 42_828.375816, 3_389.5, new KeplerOrbit(1.52371034, 0.09339410, -4.55343205, -23.94362959)),
            new Planet(
                    "Jupiter",
                    126_712_764.1,
                    69_911,
                    new KeplerOrbit(5.20288700, 0.04838624, 34.39644051, 14.72847983)),
            new Planet(
                    "Saturn",
                    37_940_584.8418,
                    58_232,
                    new KeplerOrbit(9.53667594, 0.05386179, 49.95424423, 92.59887831)),
            new Planet(
                    "Uranus",
                    5_794_556.4,
                    25_362,
                    new KeplerOrbit(19.18916464, 0.04725744, 313.23810451, 170.95427630)),
            new Planet(
                    "Neptune",
                    6_836_527.10058,
                    24_622,
                    new KeplerOrbit(30.06992276, 0.00859048, -55.12002969, 44.96476227)));

    @Override
    public String name() {
        return "solar-system";
    }

    @Override
    public String title() {
        return "Solar system";
    }

    @Override
    public Units units() {
        return new Units("AU", "M☉", "d");
    }

    /** Out to Neptune. */
    @Override
    public Aabb view() {
        return Aabb.centred(34, 31);
    }

    @Override
    public Measures measures() {
        return Measures.ENERGY_AND_MOMENTUM;
    }

    /**
     * Without contacts: the nine never come near each other, and what people drop near the Sun is followed round its centre,
     * however close it comes.
     */
    @Override
    public WorldSpec spec(long seed) {
        return WorldSpec.builder()
                .gravity(G)
                .dt(0.1)
                .adaptive(1e-16)
                .maxBodies(MOST_BODIES)
                .slowingRadius(0.5)
                .seed(seed)
                .build();
    }

    @Override
    public List<SceneBody> bodies(long seed) {
        List<BodyDef> aboutSun = new ArrayList<>();
        aboutSun.add(BodyDef.planet(0, 0, 1, SUN_RADIUS));
        for (Planet planet : PLANETS) {
            KeplerOrbit.State state = planet.orbit().state(G * (1 + planet.mass()));
            BodyDef atRest = BodyDef.planet(state.x(), state.y(), planet.mass(), planet.radiusKm() * KM);
            aboutSun.add(atRest.moving(state.vx(), state.vy()));
        }
        return aboutCentreOfMass(aboutSun).stream().map(SceneBody::plain).toList();
    }

    private static List<BodyDef> aboutCentreOfMass(List<BodyDef> bodies) {
        double mass = 0;
        double x = 0;
        double y = 0;
        double vx = 0;
        double vy = 0;
        for (BodyDef body : bodies) {
            mass += body.mass();
            x += body.mass() * body.x();
            y += body.mass() * body.y();
            vx += body.mass() * body.vx();
            vy += body.mass() * body.vy();
        }
        List<BodyDef> moved = new ArrayList<>(bodies.size());
        for (BodyDef body : bodies) {
            moved.add(body.at(body.x() - x / mass, body.y() - y / mass)
                    .moving(body.vx() - vx / mass, body.vy() - vy / mass));
        }
        return moved;
    }

    /** Planets from Mercury's size to Neptune's, asteroids about the size of Ceres. */
    @Override
    public Palette palette() {
        return new Palette(
                view(),
                new Range(1.6e-5, 1.6e-4),
                new Range(300, 700),
                new Range(1e-6, 4e-6),
                15,
                0.012,
                0.1,
                1e-6,
                1e-15,
                new ShipLimits(0.02, 2e-18));
    }
}

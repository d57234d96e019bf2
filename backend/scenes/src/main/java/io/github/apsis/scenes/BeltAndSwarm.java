package io.github.apsis.scenes;

import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import io.github.apsis.engine.math.Vec2;
import io.github.apsis.scenes.Palette.Range;
import java.util.ArrayList;
import java.util.List;

/**
 * A heavy planet with two moons, a belt of asteroids around it and a swarm of ships outside: the room that everybody
 * sees first, made to look the same after hours. Orbits are circles, counter-clockwise, v = √(G · M / r).
 *
 * <ul>
 *   <li>The planet is fixed. Ships hover on their engines and pull on it all the time; a free planet would follow a swarm
 *       that gathers on one side, and drag the belt into the walls.
 *   <li>Contacts lose nearly all of their speed. Shear heats a belt and contacts cool it; above e ≈ 0.63 they cool too little
 *       (Goldreich and Tremaine 1978, Icarus 34, 227). At e = 0.8 the belt was gone after six orbits.
 *   <li>G · M is small enough for a ship to hover at the planet's surface, G M / r² = 143 against 200 from its engine; with
 *       four times as much they fell and stayed.
 *   <li>G is small and masses are large, so that the mean asteroid outweighs a ship, and yet the escape speed of the largest,
 *       about 1, is no more than the shear across it: gravity between asteroids does not stir the belt. With five times the G, 172 of 205 were left
 *       in it after twenty minutes, against 196.
 *   <li>The moons are 10 mutual Hill radii apart; two bodies on circles stay apart for good from 2√3 on (Gladman 1993, Icarus
 *       106, 247).
 * </ul>
 *
 * <p>More bodies are smaller ones: with n of them every radius but those of planet and moons shrinks by √(248 / n) and every
 * mass by 248 / n, so that the belt is as full and as heavy as before.
 */
final class BeltAndSwarm implements ScalableScene {
    private static final int USUAL_COUNT = 248;
    private static final int PLANETS = 3;
    private static final double G = 0.05; // length³ / (mass · time²)
    private static final double PLANET_MASS = 4_800_000;
    private static final double BELT_FROM = 250;
    private static final double BELT_TO = 420;
    private static final double SMALLEST = 2.5;
    private static final double LARGEST = 11;
    private static final double DENSITY = 0.3; // mass / area
    private static final double SPIN = 1.5; // radians / time
    private static final double SHIP_MASS = 12;
    private static final ShipLimits SHIP = new ShipLimits(100, 2400);
    private static final double GAP = 2; // between rims at the start, length
    private static final Aabb BOX = Aabb.centred(1000, 1000);

    private final int count;

    BeltAndSwarm() {
        this(USUAL_COUNT);
    }

    private BeltAndSwarm(int count) {
        this.count = count;
    }

    @Override
    public Scene withBodies(int bodies) {
        if (bodies < 10) {
            throw new IllegalArgumentException("belt and swarm need 10 bodies or more, was " + bodies);
        }
        return new BeltAndSwarm(bodies);
    }

    @Override
    public String name() {
        return "belt-and-swarm";
    }

    @Override
    public String title() {
        return "Belt and swarm";
    }

    @Override
    public Units units() {
        return new Units("u", "kg", "s");
    }

    @Override
    public Aabb view() {
        return Aabb.centred(520, 450);
    }

    @Override
    public Measures measures() {
        return Measures.ENERGY_AND_MOMENTUM;
    }

    @Override
    public WorldSpec spec(long seed) {
        return WorldSpec.builder()
                .gravity(G)
                .contacts(0.1)
                .walls(BOX, 0.8)
                .seed(seed)
                .build();
    }

    @Override
    public List<SceneBody> bodies(long seed) {
        Rng rng = new Rng(seed);
        FreeSpace space = new FreeSpace(BOX, spec(seed).boundary(), 8 * LARGEST * shrink());
        int ships = (count - PLANETS) * 40 / (USUAL_COUNT - PLANETS);
        List<SceneBody> bodies = new ArrayList<>(count);
        bodies.add(SceneBody.plain(BodyDef.planet(0, 0, PLANET_MASS, 34).fixed()));
        bodies.add(onOrbit(SceneBody.plain(BodyDef.planet(0, 0, 2000, 13)), polar(160, 0.4)));
        bodies.add(onOrbit(SceneBody.plain(BodyDef.planet(0, 0, 800, 8)), polar(85, 3.5)));
        for (int i = 0; i < count - PLANETS - ships; i++) {
            bodies.add(inBelt(rng, space));
        }
        for (int i = 0; i < ships; i++) {
            bodies.add(inSwarm(rng, space));
        }
        return bodies;
    }

    private SceneBody inBelt(Rng rng, FreeSpace space) {
        double share = rng.nextDouble(); // small ones are more frequent
        double radius = (SMALLEST + (LARGEST - SMALLEST) * share * share * share) * shrink();
        SceneBody asteroid = Asteroids.random(rng, radius, DENSITY, SPIN);
        SceneBody settled = space.settle(
                asteroid, GAP * shrink(), () -> polar(rng.between(BELT_FROM, BELT_TO), rng.between(0, 2 * Math.PI)));
        return onOrbit(settled, new Vec2(settled.def().x(), settled.def().y()));
    }

    /** South-west of the belt, on its way around with it. */
    private SceneBody inSwarm(Rng rng, FreeSpace space) {
        double shrink = shrink();
        double area = shrink * shrink;
        ShipLimits limits = new ShipLimits(SHIP.maxSpeed(), SHIP.maxForce() * area);
        BodyDef ship = BodyDef.ship(0, 0, SHIP_MASS * area, rng.between(6, 8) * shrink, limits);
        SceneBody settled = space.settle(
                SceneBody.plain(ship),
                2 * GAP * shrink,
                () -> polar(rng.between(BELT_TO + 25, BELT_TO + 130), rng.between(3.0, 4.5)));
        return onOrbit(settled, new Vec2(settled.def().x(), settled.def().y()));
    }

    private static Vec2 polar(double r, double angle) {
        return new Vec2(r * StrictMath.cos(angle), r * StrictMath.sin(angle));
    }

    private static SceneBody onOrbit(SceneBody body, Vec2 place) {
        double r = place.length();
        double speed = Math.sqrt(G * PLANET_MASS / r);
        return body.at(place.x(), place.y()).moving(-place.y() / r * speed, place.x() / r * speed);
    }

    private double shrink() {
        return Math.min(1, Math.sqrt((double) USUAL_COUNT / count));
    }

    @Override
    public Palette palette() {
        return new Palette(
                view(),
                new Range(8, 14),
                new Range(1, 4),
                new Range(SMALLEST, LARGEST),
                DENSITY,
                40,
                SPIN,
                7,
                SHIP_MASS,
                SHIP);
    }
}

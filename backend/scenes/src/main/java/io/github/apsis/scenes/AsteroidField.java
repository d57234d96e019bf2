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
 * Asteroids that drift through a world without edge or gravity, and a few ships, one in twenty, that find their way between
 * them. The world repeats itself; it grows with the number of bodies, so the field is as dense for any number. In its mortal variant
 * a ship that runs into something is gone.
 */
final class AsteroidField implements ScalableScene {
    private static final double SPACING = 75; // length; each body has a square of this side on average
    private static final double SMALLEST = 4;
    private static final double LARGEST = 22;
    private static final double DENSITY = 0.3;
    private static final double FASTEST = 40; // of an asteroid, length / time
    private static final double SPIN = 1.2; // radians / time
    private static final double SHIP_RADIUS = 7;
    private static final double SHIP_MASS = 12;
    private static final double CRUISE = 80; // of a ship, length / time
    private static final ShipLimits SHIP = new ShipLimits(120, 2400);
    private static final double GAP = 3; // between rims at the start

    private static final int USUAL_COUNT = 250;

    private final int count;
    private final Ships ships;

    /** What becomes of ships that run into something. */
    enum Ships {
        BOUNCE,
        MORTAL
    }

    AsteroidField(Ships ships) {
        this(USUAL_COUNT, ships);
    }

    private AsteroidField(int count, Ships ships) {
        this.count = count;
        this.ships = ships;
    }

    @Override
    public Scene withBodies(int bodies) {
        if (bodies < 20) {
            throw new IllegalArgumentException("an asteroid field needs 20 bodies or more, was " + bodies);
        }
        return new AsteroidField(bodies, ships);
    }

    @Override
    public String name() {
        return ships == Ships.MORTAL ? "mortal-field" : "asteroid-field";
    }

    @Override
    public String title() {
        return ships == Ships.MORTAL ? "Asteroid field, mortal ships" : "Asteroid field";
    }

    @Override
    public Units units() {
        return new Units("u", "kg", "s");
    }

    @Override
    public Aabb view() {
        return box();
    }

    @Override
    public Measures measures() {
        return Measures.ENERGY_AND_MOMENTUM;
    }

    @Override
    public WorldSpec spec(long seed) {
        WorldSpec.Builder laws =
                WorldSpec.builder().contacts(0.8).periodic(box()).seed(seed);
        return (ships == Ships.MORTAL ? laws.mortalShips() : laws).build();
    }

    @Override
    public List<SceneBody> bodies(long seed) {
        Rng rng = new Rng(seed);
        FreeSpace space = new FreeSpace(box(), spec(seed).boundary(), SPACING);
        int swarm = count / 20;
        List<SceneBody> bodies = new ArrayList<>(count);
        for (int i = 0; i < count - swarm; i++) {
            bodies.add(strew(Asteroids.random(rng, asteroidRadius(rng), DENSITY, SPIN), rng, FASTEST, space));
        }
        SceneBody ship = SceneBody.plain(BodyDef.ship(0, 0, SHIP_MASS, SHIP_RADIUS, SHIP));
        for (int i = 0; i < swarm; i++) {
            bodies.add(strew(ship, rng, CRUISE, space));
        }
        return bodies;
    }

    /** Small ones are more frequent. */
    private static double asteroidRadius(Rng rng) {
        double share = rng.nextDouble();
        return SMALLEST + (LARGEST - SMALLEST) * share * share;
    }

    private SceneBody strew(SceneBody body, Rng rng, double fastest, FreeSpace space) {
        Aabb box = box();
        double direction = rng.between(0, 2 * Math.PI);
        double speed = rng.between(fastest / 4, fastest);
        SceneBody moving = body.moving(speed * StrictMath.cos(direction), speed * StrictMath.sin(direction));
        return space.settle(
                moving, GAP, () -> new Vec2(rng.between(box.minX(), box.maxX()), rng.between(box.minY(), box.maxY())));
    }

    private Aabb box() {
        double half = Math.sqrt(count) * SPACING / 2;
        return Aabb.centred(half, half);
    }

    @Override
    public Palette palette() {
        return new Palette(
                box(),
                new Range(14, 34),
                new Range(0.5, 2),
                new Range(SMALLEST, LARGEST),
                DENSITY,
                FASTEST,
                SPIN,
                SHIP_RADIUS,
                SHIP_MASS,
                SHIP);
    }
}

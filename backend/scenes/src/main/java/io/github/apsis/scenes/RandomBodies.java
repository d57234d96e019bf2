package io.github.apsis.scenes;

import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import java.util.Optional;

/**
 * Random bodies for a world that is running, each put where it overlaps nothing: inside the palette's area and the edge of
 * the world, with a gap of its own radius to its neighbours, and in a crowd a tenth of it. Empty when there is no such place.
 *
 * <p>The same seed, asked in the same order about the same snapshots, gives the same bodies. Belongs to one thread.
 */
public final class RandomBodies {
    private static final int THROWS = 200;
    private static final int SCAN_POINTS = 16_384;
    private static final double CROWDED_GAP = 0.1; // in radii

    private final Palette palette;
    private final WorldSpec spec;
    private final Rng rng;

    public RandomBodies(Palette palette, WorldSpec spec, long seed) {
        this.palette = palette;
        this.spec = spec;
        this.rng = new Rng(seed);
    }

    /** A planet at rest. Density and mass are drawn, its radius follows: r = √(m / (π · density)). */
    public Optional<SceneBody> planet(WorldSnapshot now) {
        double density = between(palette.planetDensity());
        double mass = rng.between(
                discArea(palette.planetRadius().from()) * density,
                discArea(palette.planetRadius().to()) * density);
        double radius = Math.sqrt(mass / (Math.PI * density));
        return place(SceneBody.plain(BodyDef.planet(0, 0, mass, radius)), now);
    }

    /** An asteroid on its way, turning. */
    public Optional<SceneBody> asteroid(WorldSnapshot now) {
        SceneBody asteroid = Asteroids.random(
                rng, between(palette.asteroidRadius()), palette.asteroidDensity(), palette.asteroidSpin());
        return place(anyWay(asteroid, palette.asteroidSpeed()), now);
    }

    /** A ship, at no more than a tenth of its speed. */
    public Optional<SceneBody> ship(WorldSnapshot now) {
        BodyDef ship = BodyDef.ship(0, 0, palette.shipMass(), palette.shipRadius(), palette.shipLimits());
        double gentle = palette.shipLimits().maxSpeed() / 10;
        return place(anyWay(SceneBody.plain(ship), gentle), now);
    }

    /** One of the three, all as likely. */
    public Optional<SceneBody> any(WorldSnapshot now) {
        return switch (rng.nextInt(3)) {
            case 0 -> planet(now);
            case 1 -> asteroid(now);
            default -> ship(now);
        };
    }

    private SceneBody anyWay(SceneBody body, double fastest) {
        double direction = rng.between(0, 2 * Math.PI);
        double speed = rng.between(0, fastest);
        return body.moving(speed * StrictMath.cos(direction), speed * StrictMath.sin(direction));
    }

    private Optional<SceneBody> place(SceneBody body, WorldSnapshot now) {
        Aabb area = palette.area();
        FreeSpace space = FreeSpace.around(now, area, spec.boundary());
        double radius = body.def().radius();
        for (int i = 0; i < THROWS; i++) {
            double x = rng.between(area.minX(), area.maxX());
            double y = rng.between(area.minY(), area.maxY());
            if (space.fits(x, y, radius, radius)) {
                return Optional.of(body.at(x, y));
            }
        }
        return scan(body, space);
    }

    /**
     * In a crowd luck runs out before room does: looks at every point of a square grid, as fine as the body is wide where
     * that is affordable, before it says that there is none.
     */
    private Optional<SceneBody> scan(SceneBody body, FreeSpace space) {
        Aabb area = palette.area();
        double radius = body.def().radius();
        double step = Math.max(radius, Math.sqrt(area.width() * area.height() / SCAN_POINTS));
        for (double y = area.minY() + step / 2; y < area.maxY(); y += step) {
            for (double x = area.minX() + step / 2; x < area.maxX(); x += step) {
                if (space.fits(x, y, radius, CROWDED_GAP * radius)) {
                    return Optional.of(body.at(x, y));
                }
            }
        }
        return Optional.empty();
    }

    private double between(Palette.Range range) {
        return rng.between(range.from(), range.to());
    }

    private static double discArea(double radius) {
        return Math.PI * radius * radius;
    }
}

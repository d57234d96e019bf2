package io.github.apsis.scenes;

import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import io.github.apsis.scenes.Palette.Range;
import java.util.ArrayList;
import java.util.List;

/**
 * Equal discs in a square box that lose nothing: contacts and walls of restitution 1, no gravity. Kinetic energy stays to
 * rounding, whatever the number of contacts, and the speeds settle to those of Maxwell in two dimensions.
 *
 * <p>The box grows with the number of discs: each has a square of {@link #SPACING} to itself, an area fraction of
 * π · 4² / 24² = 0.087. Each starts near the middle of its square, so none overlaps another.
 */
final class ElasticGas implements ScalableScene {
    private static final double SPACING = 24; // length
    private static final double RADIUS = 4;
    private static final double MASS = 1;
    private static final double FASTEST = 80; // per axis, length / time

    private final int count;

    ElasticGas() {
        this(500);
    }

    private ElasticGas(int count) {
        this.count = count;
    }

    @Override
    public Scene withBodies(int bodies) {
        if (bodies < 2) {
            throw new IllegalArgumentException("a gas needs 2 bodies or more, was " + bodies);
        }
        return new ElasticGas(bodies);
    }

    @Override
    public String name() {
        return "elastic-gas";
    }

    @Override
    public String title() {
        return "Elastic gas";
    }

    @Override
    public Units units() {
        return new Units("u", "kg", "s");
    }

    @Override
    public Aabb view() {
        double half = columns() * SPACING / 2 + SPACING;
        return Aabb.centred(half, half);
    }

    @Override
    public Measures measures() {
        return Measures.ENERGY_AND_MOMENTUM;
    }

    @Override
    public WorldSpec spec(long seed) {
        return WorldSpec.builder().contacts(1).walls(box(), 1).seed(seed).build();
    }

    @Override
    public List<SceneBody> bodies(long seed) {
        Rng rng = new Rng(seed);
        double[] vx = velocitiesWithoutSum(rng);
        double[] vy = velocitiesWithoutSum(rng);
        double play = SPACING / 2 - RADIUS - 0.5; // leaves a gap of 1 between neighbours, and 0.5 to the walls
        List<SceneBody> discs = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            double x = box().minX() + (i % columns() + 0.5) * SPACING + rng.between(-play, play);
            double y = box().minY() + (i / columns() + 0.5) * SPACING + rng.between(-play, play);
            BodyDef disc = BodyDef.planet(x, y, MASS, RADIUS);
            discs.add(SceneBody.plain(disc.moving(vx[i], vy[i])));
        }
        return discs;
    }

    /** Uniform, and moved so that the whole gas is at rest. */
    private double[] velocitiesWithoutSum(Rng rng) {
        double[] v = new double[count];
        double sum = 0;
        for (int i = 0; i < count; i++) {
            v[i] = rng.between(-FASTEST, FASTEST);
            sum += v[i];
        }
        for (int i = 0; i < count; i++) {
            v[i] -= sum / count;
        }
        return v;
    }

    private int columns() {
        return (int) Math.ceil(Math.sqrt(count));
    }

    private Aabb box() {
        double half = columns() * SPACING / 2;
        return Aabb.centred(half, half);
    }

    @Override
    public Palette palette() {
        return new Palette(
                box(),
                new Range(2, 5),
                new Range(0.02, 0.1),
                new Range(2, 4),
                0.02,
                FASTEST,
                1.5,
                3,
                0.5,
                new ShipLimits(120, 100));
    }
}

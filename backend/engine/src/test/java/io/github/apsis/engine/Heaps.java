package io.github.apsis.engine;

import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;

/** Circles of many sizes that fall and come to rest; three hundred after two thousand ticks or so. */
public final class Heaps {
    public static final int CIRCLES = 300;
    public static final double GRAVITY = 10; // length / time²

    private static final double WIDTH = 16;
    private static final double HEIGHT = 60;

    private Heaps() {}

    /** They fall into a box. */
    public static World inBox() {
        World world = worldOf(WIDTH);
        drop(world, CIRCLES);
        return world;
    }

    /** They fall between a wall and a dam of fixed circles of radius 0.5 at x = 16.5, with a floor to x = 24 behind it. */
    public static World behindDam() {
        return behindDam(CIRCLES);
    }

    /** The same with so many. */
    public static World behindDam(int circles) {
        World world = worldOf(1.5 * WIDTH);
        for (int i = 0; i < 40; i++) {
            world.add(BodyDef.asteroid(WIDTH + 0.5, 0.5 + i, 1, 0.5).fixed());
        }
        drop(world, circles);
        return world;
    }

    private static World worldOf(double width) {
        return new World(WorldSpec.builder()
                .law(new UniformField(0, -GRAVITY))
                .contacts(0.2)
                .walls(new Aabb(0, 0, width, HEIGHT), 0.2)
                .build());
    }

    private static void drop(World world, int circles) {
        var rng = new Rng(5);
        for (int i = 0; i < circles; i++) {
            double r = rng.between(0.3, 0.5);
            world.add(BodyDef.asteroid(0.6 + 1.1 * (i % 14), 0.6 + 1.1 * (i / 14), r * r, r)
                    .moving(rng.between(-1, 1), 0));
        }
    }
}

package io.github.apsis.scenes;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.math.Aabb;
import java.util.List;

/** A named recipe that yields a world: its laws and its bodies, the same for the same seed. */
public interface Scene {
    /** For programs and command lines, for example {@code belt-and-swarm}. */
    String name();

    /** For people, for example {@code Belt and swarm}. */
    String title();

    Units units();

    /** The part of the world that is worth looking at first. */
    Aabb view();

    Measures measures();

    /** The laws of the world. */
    WorldSpec spec(long seed);

    /** The bodies that it starts with. */
    List<SceneBody> bodies(long seed);

    /** What a random body of this scene is like, and where it may be put. */
    Palette palette();

    /** A world with all bodies in it, for those who do not care how they look. */
    default World world(long seed) {
        return world(seed, spec(seed).threads());
    }

    /** The same world, with the same bits, stepped by so many threads; {@link World#close} ends them. */
    default World world(long seed, int threads) {
        World world = new World(spec(seed).withThreads(threads));
        for (SceneBody body : bodies(seed)) {
            world.add(body.def());
        }
        return world;
    }
}

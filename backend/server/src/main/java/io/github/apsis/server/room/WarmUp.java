package io.github.apsis.server.room;

import io.github.apsis.engine.World;
import io.github.apsis.scenes.Scene;
import java.util.concurrent.TimeUnit;

/**
 * Ticks a world that nobody sees before the clock of the real one starts: a tick that the JIT has not compiled yet takes
 * some thirty times as long, and the first seconds of a room would come late.
 */
public final class WarmUp {
    private static final long MOST_NANOS = TimeUnit.MILLISECONDS.toNanos(1500);

    private WarmUp() {}

    /** Takes a second and a half, on the calling thread. */
    public static void run(Scene scene, long seed) {
        World world = scene.world(seed);
        long begin = System.nanoTime();
        while (System.nanoTime() - begin < MOST_NANOS) {
            world.step();
            world.snapshot();
        }
        world.conserved();
    }
}

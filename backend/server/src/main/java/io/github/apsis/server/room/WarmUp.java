package io.github.apsis.server.room;

import io.github.apsis.engine.World;
import io.github.apsis.scenes.Scene;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.concurrent.TimeUnit;

/**
 * Ticks a world that nobody sees before the clock of the real one starts: a tick that the JIT has not compiled yet takes
 * some thirty times as long, and the first seconds of a room would come late. The last of these ticks tell what the room will
 * cost.
 */
public final class WarmUp {
    private static final long MOST_NANOS = TimeUnit.MILLISECONDS.toNanos(1500);
    private static final long MEASURED_NANOS = TimeUnit.MILLISECONDS.toNanos(500);
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private WarmUp() {}

    /**
     * Takes a second and a half, on the calling thread.
     *
     * @return the load of a room with this scene: the share of a processor that 150 ticks a second take. By CPU time, so that a
     *     machine that is busy with something else does not count.
     */
    public static double run(Scene scene, long seed) {
        World world = scene.world(seed);
        tickFor(world, MOST_NANOS - MEASURED_NANOS);
        long cpu = THREADS.getCurrentThreadCpuTime();
        long ticks = tickFor(world, MEASURED_NANOS);
        double load = (THREADS.getCurrentThreadCpuTime() - cpu) * 1e-9 / ticks * TickLoop.TICKS_PER_SECOND;
        world.conserved();
        return load;
    }

    /** At least one tick. */
    private static long tickFor(World world, long nanos) {
        long begin = System.nanoTime();
        long ticks = 0;
        do {
            world.step();
            world.snapshot();
            ticks++;
        } while (System.nanoTime() - begin < nanos);
        return ticks;
    }
}

package io.github.apsis.benchmarks;

import com.sun.management.ThreadMXBean;
import io.github.apsis.engine.World;
import io.github.apsis.scenes.Scene;
import java.lang.management.ManagementFactory;
import java.util.function.LongConsumer;

/**
 * Ticks a scene as fast as it goes, and measures. A world of its own warms the compiler up first and is thrown away, so the
 * measured world starts at tick 0 and its final state depends on scene, seed and number of ticks alone.
 */
public final class SceneRun {
    /** The rate at which a room ticks. */
    public static final int TICKS_PER_SECOND = 150;

    private static final int CHUNK = 150;
    private static final long WARM_UP_NANOS = 3_000_000_000L;

    private final Scene scene;
    private final long seed;
    private final int threads;
    private final ThreadMXBean counters = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    /**
     * A run of this scene.
     *
     * @param threads that step the world
     */
    public SceneRun(Scene scene, long seed, int threads) {
        this.scene = scene;
        this.seed = seed;
        this.threads = threads;
    }

    /**
     * What came out.
     *
     * @param warmUpTicks of the world that was thrown away
     * @param firstTickBytes allocated by the first tick, in which a new world asks for its scratch memory
     * @param allocatedBytes by all others together: lists that grow when more bodies touch than ever before
     * @param balance of the measured world, looked at once in a simulated second
     * @param stateHash after the last tick
     */
    public record Result(
            long warmUpTicks,
            TickTimes times,
            long firstTickBytes,
            long allocatedBytes,
            Balance balance,
            long stateHash) {}

    /**
     * Warms up, then measures so many ticks.
     *
     * @param progress is told the number of measured ticks now and then, outside the measured time
     */
    public Result measure(long ticks, LongConsumer progress) {
        long warmUpTicks = warmUp(ticks);
        World world = scene.world(seed, threads);
        Balance balance = new Balance(world);
        TickTimes times = new TickTimes();
        long firstTick = 0;
        long allocated = 0;
        while (times.count() < ticks) {
            long begin = counters.getCurrentThreadAllocatedBytes();
            long end = Math.min(times.count() + CHUNK, ticks);
            if (times.count() == 0) {
                tick(world, times, 1);
                firstTick = counters.getCurrentThreadAllocatedBytes() - begin;
                begin += firstTick;
            }
            tick(world, times, end - times.count());
            allocated += counters.getCurrentThreadAllocatedBytes() - begin;
            balance.look();
            progress.accept(times.count());
        }
        world.close();
        return new Result(warmUpTicks, times, firstTick, allocated, balance, world.stateHash());
    }

    /** As many ticks as will be measured, but no more than three seconds of them. */
    private long warmUp(long ticks) {
        World world = scene.world(seed, threads);
        TickTimes discarded = new TickTimes();
        while (discarded.count() < ticks && discarded.totalNanos() < WARM_UP_NANOS) {
            tick(world, discarded, Math.min(CHUNK, ticks - discarded.count()));
        }
        world.close();
        return discarded.count();
    }

    private static void tick(World world, TickTimes times, long ticks) {
        for (long i = 0; i < ticks; i++) {
            long before = System.nanoTime();
            world.step();
            times.record(System.nanoTime() - before);
        }
    }
}

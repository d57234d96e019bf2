package io.github.apsis.engine;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Rng;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadInfo;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** What a tick leaves to the garbage collector: nothing, once its scratch memory has grown to the scene. */
class AllocationTest {
    private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    @Test
    void gravity_by_the_direct_sum_allocates_nothing() {
        assertNothingIsAllocated(spec().build(), 600);
    }

    @Test
    void gravity_by_a_tree_allocates_nothing() {
        assertNothingIsAllocated(spec().tree(0.6).build(), 2000);
    }

    @Test
    void gravity_that_looks_at_its_error_allocates_nothing() {
        assertNothingIsAllocated(spec().forceError(1e-3).build(), 2000);
    }

    @Test
    void gravity_by_two_threads_allocates_nothing() {
        assertNothingIsAllocated(spec().tree(0.6).threads(2).build(), 2000);
        assertNothingIsAllocated(spec().threads(2).build(), 1200);
    }

    private static void assertNothingIsAllocated(WorldSpec spec, int count) {
        try (World world = crowd(spec, count)) {
            run(world, 130); // past two looks at the error
            long[] threads = threadsOfTheWorld();
            sum(THREADS.getThreadAllocatedBytes(threads)); // the first look loads classes

            // The least of three rounds: a class that is loaded late shows in one, an object that a tick leaves in all.
            long bytes = Long.MAX_VALUE;
            for (int round = 0; round < 3; round++) {
                long before = sum(THREADS.getThreadAllocatedBytes(threads));
                run(world, 130);
                bytes = Math.min(bytes, sum(THREADS.getThreadAllocatedBytes(threads)) - before);
            }

            // The look itself leaves two short arrays behind; a tick that left one object would show 130 of them.
            assertThat(bytes).isLessThan(1000);
        }
    }

    private static long[] threadsOfTheWorld() {
        return Arrays.stream(THREADS.getThreadInfo(THREADS.getAllThreadIds()))
                .filter(thread -> thread.getThreadId() == Thread.currentThread().getId()
                        || thread.getThreadName().startsWith("apsis-"))
                .mapToLong(ThreadInfo::getThreadId)
                .toArray();
    }

    private static long sum(long[] bytes) {
        return Arrays.stream(bytes).filter(b -> b > 0).sum(); // −1 for one that has ended
    }

    private static WorldSpec.Builder spec() {
        return WorldSpec.builder().gravity(1).softening(0.05);
    }

    /** A round cloud of total mass 1 and radius 1 at rest. */
    private static World crowd(WorldSpec spec, int count) {
        var rng = new Rng(9);
        World world = new World(spec);
        while (world.count() < count) {
            double x = rng.between(-1, 1);
            double y = rng.between(-1, 1);
            if (x * x + y * y < 1) {
                world.add(BodyDef.planet(x, y, 1.0 / count, 0));
            }
        }
        return world;
    }
}

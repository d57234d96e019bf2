package io.github.apsis.engine;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Rng;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** One world by several threads. */
class ThreadsTest {
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 8})
    void a_world_has_the_same_history_by_any_number_of_threads(int threads) {
        assertSameHistory(threads, 1200, spec -> spec.tree(0.6));
        assertSameHistory(threads, 1000, spec -> spec);
        assertSameHistory(threads, 2500, spec -> spec.forceError(1e-3));
    }

    /** So many that their pairs are shared as well; in a tree, since the direct sum of so many takes its time. */
    @ParameterizedTest
    @ValueSource(ints = {2, 3, 8})
    void a_crowd_that_collides_has_the_same_history_by_any_number_of_threads(int threads) {
        WorldSpec.Builder colliding = spec().tree(0.9).contacts(0.9);
        try (World alone = heap(colliding.build(), 4500);
                World together = heap(colliding.threads(threads).build(), 4500)) {
            long[] bounces = new long[1];
            together.onBounce((time, first, second, closingSpeed, impulse) -> bounces[0]++);
            run(alone, 40);
            run(together, 40);

            assertThat(bounces[0]).isGreaterThan(1000);
            assertThat(together.stateHash()).isEqualTo(alone.stateHash());
        }
    }

    private static void assertSameHistory(int threads, int count, UnaryOperator<WorldSpec.Builder> gravity) {
        try (World alone = crowd(gravity.apply(spec()).build(), count);
                World together = crowd(gravity.apply(spec()).threads(threads).build(), count)) {
            run(alone, 70); // past a second look of the solver at its error
            run(together, 70);

            assertThat(together.stateHash()).isEqualTo(alone.stateHash());
        }
    }

    @Test
    void a_closed_world_goes_on_by_one_thread() {
        try (World closed = crowd(spec().tree(0.6).threads(2).build(), 2000);
                World open = crowd(spec().tree(0.6).threads(2).build(), 2000)) {
            run(closed, 5);
            closed.close();
            run(closed, 10);
            run(open, 10);

            assertThat(closed.stateHash()).isEqualTo(open.stateHash());
        }
    }

    @Test
    void a_small_world_starts_no_threads() {
        int before = Thread.activeCount();

        try (World small = crowd(spec().threads(4).build(), 200)) {
            run(small, 10);

            assertThat(Thread.activeCount()).isLessThanOrEqualTo(before); // those of other tests may end meanwhile
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, -3, 257})
    void a_world_has_at_least_one_thread(int threads) {
        assertThatThrownBy(() -> WorldSpec.builder().threads(threads))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("threads must be 1 to 256, was " + threads);
    }

    private static WorldSpec.Builder spec() {
        return WorldSpec.builder().gravity(1).softening(0.01).seed(3);
    }

    /** Discs of many sizes, as close as they come without touching on a square lattice, each on its own way. */
    private static World heap(WorldSpec spec, int count) {
        var rng = new Rng(4);
        World world = new World(spec);
        int columns = (int) Math.sqrt(count);
        while (world.count() < count) {
            double x = world.count() % columns;
            double y = world.count() / columns;
            double radius = 0.5 * StrictMath.pow(10, rng.between(-1.5, 0)) * 0.999;
            world.add(BodyDef.planet(x, y, radius * radius, radius).moving(rng.between(-5, 5), rng.between(-5, 5)));
        }
        return world;
    }

    /** A round cloud of total mass 1 and radius 1; every 50th body is a ship. */
    private static World crowd(WorldSpec spec, int count) {
        var rng = new Rng(9);
        World world = new World(spec);
        while (world.count() < count) {
            double x = rng.between(-1, 1);
            double y = rng.between(-1, 1);
            if (x * x + y * y < 1) {
                world.add(
                        world.count() % 50 == 0
                                ? BodyDef.ship(x, y, 0.1 / count, 0, new ShipLimits(1, 1))
                                : BodyDef.planet(x, y, 1.0 / count, 0));
            }
        }
        return world;
    }
}

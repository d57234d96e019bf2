package io.github.apsis.engine.collision;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import org.junit.jupiter.api.Test;

/** What lies still, what moves though it is slow, and the books of both. */
class StandstillTest {
    private static final double G = 10;
    private static final double DT = 1.0 / 150;

    @Test
    void a_heap_that_has_come_to_rest_stays_where_it_is_to_the_bit() {
        World heap = heap();
        run(heap, 1500);
        WorldSnapshot before = heap.snapshot();

        run(heap, 3000);

        WorldSnapshot now = heap.snapshot();
        for (int i = 0; i < now.count(); i++) {
            assertThat(now.x(i)).as("circle %d", i).isEqualTo(before.x(i));
            assertThat(now.y(i)).as("circle %d", i).isEqualTo(before.y(i));
            assertThat(Math.hypot(now.vx(i), now.vy(i))).as("circle %d", i).isZero();
        }
    }

    @Test
    void its_books_stay_right() {
        World heap = heap();
        var before = heap.conserved();
        double energy = before.energy().orElseThrow();

        run(heap, 3000);

        var now = heap.conserved();
        // The same tick again and again rounds to the same side: a unit in the last place in each.
        assertThat(now.energy().orElseThrow() - heap.ledger().energy())
                .isCloseTo(energy, within(3000 * 0x1p-52 * energy));
        assertThat(now.momentumX() - heap.ledger().momentumX())
                .isCloseTo(before.momentumX(), within(1e-12 * before.momentumScale()));
    }

    @Test
    void who_strikes_it_sets_it_in_motion() {
        World heap = heap();
        run(heap, 1500);
        WorldSnapshot before = heap.snapshot();

        heap.add(BodyDef.asteroid(4, 30, 1, 0.5).moving(0, -20));
        run(heap, 1800);

        WorldSnapshot now = heap.snapshot();
        int moved = 0;
        for (int i = 0; i < before.count(); i++) {
            moved += Math.hypot(now.x(i) - before.x(i), now.y(i) - before.y(i)) > 1e-3 ? 1 : 0;
        }
        assertThat(moved).isGreaterThan(5);
    }

    @Test
    void a_floor_so_steep_that_it_gives_more_than_a_hundred_thousandth_of_the_weight_lets_slide() {
        double sideways = 3e-5 * G;
        World floor = new World(WorldSpec.builder()
                .law(new UniformField(sideways, -G))
                .contacts(0)
                .walls(new Aabb(0, 0, 20, 20), 0)
                .build());
        floor.add(BodyDef.asteroid(5, 1, 1, 1));

        run(floor, 1500);

        double t = 1500 * DT;
        assertThat(floor.snapshot().x(0)).isCloseTo(5 + 0.5 * sideways * t * t, within(1e-9));
    }

    @Test
    void slow_bodies_that_lie_on_nothing_go_on() {
        World pair = new World(WorldSpec.builder().gravity(10).contacts(0).build());
        double v = 1e-9; // a tick of their pull gives 0.0167
        pair.add(BodyDef.asteroid(0, 0, 1, 1).moving(v, 0));
        pair.add(BodyDef.asteroid(2, 0, 1, 1).moving(v, 0));

        run(pair, 3000);

        assertThat(pair.snapshot().x(0)).isCloseTo(v * 3000 * DT, within(1e-12));
        assertThat(pair.snapshot().vx(1)).isCloseTo(v, within(1e-15));
    }

    /** Sixty circles of many sizes that fall into a box. */
    private static World heap() {
        World world = new World(WorldSpec.builder()
                .law(new UniformField(0, -G))
                .contacts(0.2)
                .walls(new Aabb(0, 0, 8, 40), 0.2)
                .build());
        var rng = new Rng(5);
        for (int i = 0; i < 60; i++) {
            double r = rng.between(0.3, 0.5);
            world.add(BodyDef.asteroid(0.6 + 1.1 * (i % 7), 0.6 + 1.1 * (i / 7), r * r, r)
                    .moving(rng.between(-1, 1), 0));
        }
        return world;
    }
}

package io.github.apsis.engine.collision;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.Heaps;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.spatial.Workspace;
import org.junit.jupiter.api.Test;

/** What lies still, what moves though it is slow, and the books of both. */
class StandstillTest {
    private static final double G = 10;
    private static final double DT = 1.0 / 150;
    private static final double CREEP = 1e-4;
    private static final double STILL = CREEP * G * DT; // speed
    private static final int FLOOR = -3;

    private final Bodies bodies = new Bodies();
    private final Paths paths = new Paths();
    private final Touching touching = new Touching();
    private final HeldBodies held = new HeldBodies();
    private final Standstill standstill =
            new Standstill(paths, touching, held, new LyingHeaps(paths, touching), new Workspace());
    private final ContactGeometry contact = new ContactGeometry(null, null);

    @Test
    void a_heap_of_hundreds_that_has_come_to_rest_stays_where_it_is_to_the_bit_until_it_is_struck() {
        World heap = Heaps.inBox();
        double dropped = heap.conserved().energy().orElseThrow();
        run(heap, 2250); // a loose one slides on for twelve seconds
        WorldSnapshot before = heap.snapshot();

        run(heap, 3000);

        WorldSnapshot now = heap.snapshot();
        for (int i = 0; i < now.count(); i++) {
            assertThat(now.x(i)).as("circle %d", i).isEqualTo(before.x(i));
            assertThat(now.y(i)).as("circle %d", i).isEqualTo(before.y(i));
        }
        // The same tick again and again rounds to the same side: a unit in the last place in each.
        assertThat(heap.conserved().energy().orElseThrow() - heap.ledger().energy())
                .isCloseTo(dropped, within(3000 * 0x1p-52 * dropped));

        heap.add(BodyDef.asteroid(8, 40, 1, 0.5).moving(0, -40));
        run(heap, 3300);

        WorldSnapshot struck = heap.snapshot();
        int moved = 0;
        for (int i = 0; i < now.count(); i++) {
            moved += Math.hypot(struck.x(i) - now.x(i), struck.y(i) - now.y(i)) > 1e-3 ? 1 : 0;
        }
        assertThat(moved).isGreaterThan(10);
    }

    /** A static friction that could be felt would stop it: of a ten-millionth of its weight here. */
    @Test
    void who_slides_alone_on_a_floor_slides_on_however_slowly() {
        World world = new World(WorldSpec.builder()
                .law(new UniformField(0, -G))
                .contacts(0.2)
                .walls(new Aabb(0, 0, 10, 10), 0.2)
                .build());
        double speed = 1e-7 * G * DT;
        world.add(BodyDef.asteroid(5, 1, 1, 1).moving(speed, 0));

        run(world, 15_000);

        // Each tick adds a path to 5 and rounds: half a unit in the last place.
        assertThat(world.snapshot().vx(0)).isEqualTo(speed);
        assertThat(world.snapshot().x(0)).isCloseTo(5 + speed * world.time(), within(15_000 * 0x1p-51));
    }

    @Test
    void what_a_floor_bears_and_hardly_moves_is_put_back_and_booked() {
        int lower = slow(0, 1, 0.9 * STILL);
        int upper = slow(0, 3, -0.9 * STILL);
        touch(lower, FLOOR);
        touch(lower, upper);

        stop();

        assertThat(bodies.x(lower)).isEqualTo(0);
        assertThat(bodies.y(upper)).isEqualTo(3);
        assertThat(bodies.vx(lower)).isZero();
        assertThat(bodies.vx(upper)).isZero();
        assertThat(bodies.ledger().momentumX()).isZero(); // 0.9 − 0.9
        assertThat(bodies.ledger().energy()).isCloseTo(-0.81 * STILL * STILL, within(1e-15 * STILL * STILL));
    }

    @Test
    void who_is_faster_goes_on_with_all_he_touches() {
        int lower = slow(0, 1, 0.5 * STILL);
        int upper = slow(0, 3, 1.1 * STILL);
        touch(lower, FLOOR);
        touch(lower, upper);

        stop();

        assertThat(bodies.vx(lower)).isEqualTo(0.5 * STILL);
        assertThat(bodies.vx(upper)).isEqualTo(1.1 * STILL);
    }

    @Test
    void heaps_do_not_ask_each_other() {
        int still = slow(0, 1, 0.5 * STILL);
        int sliding = slow(9, 1, 2 * STILL);
        touch(still, FLOOR);
        touch(sliding, FLOOR);

        stop();

        assertThat(bodies.vx(still)).isZero();
        assertThat(bodies.vx(sliding)).isEqualTo(2 * STILL);
    }

    @Test
    void bodies_that_only_have_each_other_go_on() {
        int one = slow(0, 1, 0.5 * STILL);
        int other = slow(2, 1, 0.5 * STILL);
        touch(one, other);

        stop();

        assertThat(bodies.vx(one)).isEqualTo(0.5 * STILL);
        assertThat(bodies.vx(other)).isEqualTo(0.5 * STILL);
    }

    @Test
    void a_fixed_body_bears_as_a_wall_does() {
        int fixed = bodies.add(BodyDef.planet(0, -10, 1, 10).fixed());
        int on = slow(0, 1, 0.5 * STILL);
        touch(fixed, on);

        stop();

        assertThat(bodies.vx(on)).isZero();
    }

    private int slow(double x, double y, double vx) {
        return bodies.add(BodyDef.asteroid(x, y, 1, 1).moving(vx, 0));
    }

    private void touch(int a, int b) {
        contact.nx = 0;
        contact.ny = b < 0 ? -1 : 1;
        touching.add(a, b, contact);
    }

    /** A tick in which all go on as they are. */
    private void stop() {
        for (int i = 0; i < bodies.count(); i++) {
            bodies.accelerate(i, 0, -G);
        }
        paths.begin(bodies, DT);
        bodies.drift(DT);
        held.note(bodies, touching);
        standstill.stop(bodies, CREEP, true);
    }
}

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
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/**
 * Some hundred circles of many sizes dropped into a box, twelve seconds later. More of them: {@code -Dapsis.pile=5000}, which get more
 * time: waves cross a pile as wide as it is high.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class PileTest {
    private static final int COUNT = Integer.getInteger("apsis.pile", 500);
    private static final long SECONDS = Math.round(12 * Math.sqrt(COUNT / 500.0));
    private static final long SEED = 11;

    private final World world = pile();
    private final double dropped = world.conserved().energy().orElseThrow();
    private double highest = dropped;

    @BeforeAll
    void let_it_settle() {
        for (int second = 1; second <= SECONDS; second++) {
            run(world, 150L * second);
            highest = Math.max(highest, world.conserved().energy().orElseThrow());
        }
    }

    @Test
    void nobody_lies_deep_in_another() {
        WorldSnapshot now = world.snapshot();
        double deepest = 0;
        double sum = 0;
        int contacts = 0;
        for (int i = 0; i < now.count(); i++) {
            for (int j = i + 1; j < now.count(); j++) {
                double smaller = Math.min(now.radius(i), now.radius(j));
                double gap = Math.hypot(now.x(i) - now.x(j), now.y(i) - now.y(j)) - now.radius(i) - now.radius(j);
                if (gap < 1e-6 * smaller) {
                    contacts++;
                    sum += Math.max(0, -gap / smaller);
                    deepest = Math.max(deepest, -gap / smaller);
                }
            }
        }

        // The measure of what an eye sees as lying on each other (half a percent) and in each other (five).
        assertThat(contacts).as("contacts, seed %d", SEED).isGreaterThan(COUNT); // it is a pile
        assertThat(sum / contacts).as("mean overlap, radii, seed %d", SEED).isLessThan(0.005);
        assertThat(deepest).as("deepest overlap, radii, seed %d", SEED).isLessThan(0.05);
        assertThat(Depth.inWalls(now, world.spec().boundary())).as("in a wall").isLessThan(0.05);
    }

    @Test
    void it_never_has_more_energy_than_it_was_dropped_with() {
        assertThat(highest).as("seed %d", SEED).isLessThanOrEqualTo(dropped * (1 + 1e-12));
    }

    @Test
    void nothing_moves_any_more() {
        WorldSnapshot before = world.snapshot();
        assertThat(world.conserved().kinetic()).as("seed %d", SEED).isLessThan(1e-12 * dropped);

        run(world, world.tick() + 150);

        WorldSnapshot now = world.snapshot();
        for (int i = 0; i < now.count(); i++) {
            // Under an arch a circle may be alone with the floor: without friction nothing may stop it, nor drive it.
            double drift = touchesAnother(before, i) ? 0 : before.vx(i);
            assertThat(now.x(i)).as("circle %d, seed %d", i, SEED).isCloseTo(before.x(i) + drift, within(1e-6));
            assertThat(now.y(i)).as("circle %d, seed %d", i, SEED).isCloseTo(before.y(i), within(1e-6));
        }
    }

    private static boolean touchesAnother(WorldSnapshot now, int i) {
        for (int j = 0; j < now.count(); j++) {
            double gap = Math.hypot(now.x(i) - now.x(j), now.y(i) - now.y(j)) - now.radius(i) - now.radius(j);
            if (j != i && gap < 1e-6) {
                return true;
            }
        }
        return false;
    }

    /** Rows of circles above each other in a box that they will fill to about its half. */
    private static World pile() {
        int columns = (int) Math.sqrt(COUNT);
        World world = new World(WorldSpec.builder()
                .law(new UniformField(0, -10))
                .contacts(0.3)
                .walls(new Aabb(0, 0, 1.3 * columns, 10 * columns), 0.3)
                .build());
        var rng = new Rng(SEED);
        for (int i = 0; i < COUNT; i++) {
            double r = rng.between(0.3, 0.6);
            double x = 0.65 + 1.3 * (i % columns) * 0.999;
            world.add(BodyDef.asteroid(x, 0.65 + 1.3 * (i / columns), r * r, r).moving(rng.between(-1, 1), 0));
        }
        return world;
    }
}

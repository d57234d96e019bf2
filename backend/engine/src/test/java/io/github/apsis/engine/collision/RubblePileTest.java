package io.github.apsis.engine.collision;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.math.Rng;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/** A cloud of four hundred rocks that turns, falls together by its own gravity and then turns as one, a quarter of a radian a second. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class RubblePileTest {
    private static final int ROCKS = 400;
    private static final long SEED = 7;
    private static final long SETTLED = 14 * 150;
    private static final long LATER = SETTLED + 2 * 150;

    private final World world = cloud();
    private WorldSnapshot settled = world.snapshot();
    private WorldSnapshot later = settled;
    private Conserved before = world.conserved();
    private Conserved after = before;

    @BeforeAll
    void let_it_settle() {
        run(world, SETTLED);
        settled = world.snapshot();
        before = world.conserved();
        run(world, LATER);
        later = world.snapshot();
        after = world.conserved();
    }

    @Test
    void it_is_a_pile_that_turns() {
        double spin = after.angularMomentum() / momentOfInertia(later);

        assertThat(spin).as("radians per time, seed %d", SEED).isGreaterThan(0.2);
        assertThat(Depth.ofPairs(later, world.spec().boundary())).isLessThan(0.01);
    }

    @Test
    void it_turns_as_a_rigid_body() {
        // It has turned by half a radian, so its rim by fifteen. What still settles does by less than a
        // hundred-thousandth of that.
        double farthest = 0;
        for (int i = 0; i < ROCKS; i++) {
            for (int j = 0; j < i; j++) {
                farthest = Math.max(farthest, Math.abs(distance(later, i, j) - distance(settled, i, j)));
            }
        }

        assertThat(farthest).as("length, seed %d", SEED).isLessThan(1e-4);
    }

    @Test
    void nothing_takes_its_energy_or_turns_it_any_more() {
        assertThat(after.energy().orElseThrow() / before.energy().orElseThrow())
                .as("seed %d", SEED)
                .isCloseTo(1, within(1e-8));
        assertThat(after.angularMomentum() / before.angularMomentum())
                .as("seed %d", SEED)
                .isCloseTo(1, within(1e-8));
    }

    private static double momentOfInertia(WorldSnapshot now) {
        double sum = 0;
        for (int i = 0; i < now.count(); i++) {
            sum += now.mass(i) * (now.x(i) * now.x(i) + now.y(i) * now.y(i));
        }
        return sum;
    }

    private static double distance(WorldSnapshot now, int i, int j) {
        return Math.hypot(now.x(i) - now.x(j), now.y(i) - now.y(j));
    }

    private static World cloud() {
        World world = new World(WorldSpec.builder().gravity(30).contacts(0.2).build());
        var rng = new Rng(SEED);
        double spin = 0.05; // radians / time
        double reach = 64;
        while (world.count() < ROCKS) {
            double x = rng.between(-reach, reach);
            double y = rng.between(-reach, reach);
            double r = rng.between(0.7, 1.3);
            if (x * x + y * y < reach * reach && isFree(world.snapshot(), x, y, r)) {
                world.add(BodyDef.asteroid(x, y, r * r, r).moving(-spin * y, spin * x));
            }
        }
        return world;
    }

    private static boolean isFree(WorldSnapshot now, double x, double y, double r) {
        for (int i = 0; i < now.count(); i++) {
            if (Math.hypot(now.x(i) - x, now.y(i) - y) < now.radius(i) + r) {
                return false;
            }
        }
        return true;
    }
}

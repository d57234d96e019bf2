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
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Fifty discs of radius 1 that are born inside a circle of radius 2: they spread, they do not burst. */
class CrowdTest {
    private static final int DISCS = 50;
    private static final double FASTEST = 10; // radii / time
    private static final double RESTITUTION = 0.5;

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void nobody_is_pushed_out_faster_than_ten_radii_a_second(long seed) {
        World world = crowd(seed, 0);

        WorldSnapshot before = world.snapshot();
        for (int tick = 0; tick < 300; tick++) {
            world.step();
            WorldSnapshot now = world.snapshot();
            for (int i = 0; i < DISCS; i++) {
                double way = Math.hypot(now.x(i) - before.x(i), now.y(i) - before.y(i));
                assertThat(way).as("disc %d, seed %d, tick %d", i, seed, tick).isLessThan(FASTEST / 150 * (1 + 1e-9));
                assertThat(Math.hypot(now.vx(i), now.vy(i)))
                        .as("disc %d, seed %d", i, seed)
                        .isLessThan(1e-12);
            }
            before = now;
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void all_lie_beside_each_other_in_the_end_and_their_centre_where_it_was(long seed) {
        World world = crowd(seed, 0);
        var centre = world.conserved().centreOfMass().orElseThrow();

        run(world, 600); // fifty discs cover a circle of radius 8: at ten radii a second, a second would do

        WorldSnapshot now = world.snapshot();
        assertThat(Depth.ofPairs(now, world.spec().boundary()))
                .as("seed %d", seed)
                .isLessThan(1e-3);
        var then = world.conserved().centreOfMass().orElseThrow();
        assertThat(then.x()).as("seed %d", seed).isCloseTo(centre.x(), within(1e-12));
        assertThat(then.y()).as("seed %d", seed).isCloseTo(centre.y(), within(1e-12));
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void a_crowd_in_motion_keeps_momentum_and_gains_no_energy(long seed) {
        World world = crowd(seed, 20);
        Conserved start = world.conserved();

        for (int tick = 0; tick < 300; tick++) {
            world.step();

            Conserved now = world.conserved();
            double error = Math.hypot(now.momentumX() - start.momentumX(), now.momentumY() - start.momentumY());
            assertThat(error / start.momentumScale())
                    .as("seed %d, tick %d", seed, tick)
                    .isLessThan(1e-12);
            assertThat(now.kinetic()).as("seed %d, tick %d", seed, tick).isLessThan(start.kinetic() * (1 + 1e-12));
        }
    }

    private static World crowd(long seed, double fastest) {
        World world = new World(WorldSpec.builder().contacts(RESTITUTION).build());
        var rng = new Rng(seed);
        while (world.count() < DISCS) {
            double x = rng.between(-1, 1);
            double y = rng.between(-1, 1);
            if (Math.hypot(x, y) < 1) {
                world.add(BodyDef.asteroid(x, y, rng.between(0.5, 2), 1)
                        .moving(rng.between(-fastest, fastest), rng.between(-fastest, fastest)));
            }
        }
        return world;
    }
}

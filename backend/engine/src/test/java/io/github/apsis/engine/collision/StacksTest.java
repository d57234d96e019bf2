package io.github.apsis.engine.collision;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Rows and towers of circles of radius 1 that a field presses on a wall, whatever their masses are. */
class StacksTest {
    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e6, 1e9})
    void a_light_ball_carries_a_heavy_one(double heavy) {
        World world = tower(1, heavy);

        run(world, 1500);

        assertIsAtRest(world);
    }

    private static void assertIsAtRest(World world) {
        WorldSnapshot now = world.snapshot();
        assertThat(depth(world)).as("deepest overlap, radii").isLessThan(0.01);
        for (int i = 0; i < now.count(); i++) {
            assertThat(Math.hypot(now.vx(i), now.vy(i))).as("speed of %d", i).isLessThan(1e-6);
        }
    }

    private static double depth(World world) {
        WorldSnapshot now = world.snapshot();
        Boundary edge = world.spec().boundary();
        return Math.max(Depth.ofPairs(now, edge), Depth.inWalls(now, edge));
    }

    /** Touching balls on each other, the first of them on the floor. */
    private static World tower(double... masses) {
        World world = new World(WorldSpec.builder()
                .law(new UniformField(0, -10))
                .contacts(0.3)
                .walls(new Aabb(-10, 0, 10, 100), 0.3)
                .build());
        for (int k = 0; k < masses.length; k++) {
            world.add(BodyDef.asteroid(0, 1 + 2 * k, masses[k], 1));
        }
        return world;
    }
}

package io.github.apsis.engine.collision;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Rows and towers of circles of radius 1 that a field presses on a wall, whatever their masses are. */
class StacksTest {
    @ParameterizedTest
    @ValueSource(strings = {"light at the wall", "heavy at the wall", "alternating", "growing", "shrinking"})
    void a_chain_of_masses_one_to_a_million_pressed_on_a_wall_holds(String order) {
        World world = pressed(
                100, IntStream.range(0, 10).mapToDouble(k -> mass(order, k)).toArray());

        run(world, 450);

        assertThat(depth(world)).isLessThan(0.01);
    }

    private static double mass(String order, int k) {
        return switch (order) {
            case "light at the wall" -> k < 9 ? 1 : 1e6;
            case "heavy at the wall" -> k == 0 ? 1e6 : 1;
            case "alternating" -> k % 2 == 0 ? 1 : 1e6;
            case "growing" -> Math.pow(10, k * 6 / 9.0);
            default -> Math.pow(10, 6 - k * 6 / 9.0);
        };
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e3, 1e6, 1e9})
    void a_light_ball_carries_a_heavy_one(double heavy) {
        World world = tower(1, heavy);

        run(world, 1500);

        assertIsAtRest(world);
    }

    @ParameterizedTest
    @CsvSource({"10, 2", "10, 0.5", "5, 100", "5, 0.01"})
    void a_tower_stands_whose_levels_grow_or_shrink(int levels, double factor) {
        World world = tower(
                IntStream.range(0, levels).mapToDouble(k -> Math.pow(factor, k)).toArray());

        run(world, 1500);

        assertIsAtRest(world);
    }

    @ParameterizedTest
    @ValueSource(doubles = {10, 1e3, 1e6})
    void a_tower_of_light_and_heavy_balls_in_turn_stands(double heavy) {
        World world = tower(
                IntStream.range(0, 10).mapToDouble(k -> k % 2 == 0 ? 1 : heavy).toArray());

        run(world, 1500);

        assertIsAtRest(world);
    }

    @Test
    void a_hundred_equal_balls_in_a_row_press_on_a_wall() {
        World world = pressed(10, IntStream.range(0, 100).mapToDouble(k -> 1).toArray());

        run(world, 450);

        assertIsAtRest(world);
    }

    @ParameterizedTest
    @ValueSource(ints = {4, 10})
    void a_pyramid_between_walls_stands(int base) {
        World world = new World(WorldSpec.builder()
                .law(new UniformField(0, -10))
                .contacts(0.3)
                .walls(new Aabb(-base, 0, base, 100), 0.3)
                .build());
        for (int row = 0; row < base; row++) {
            for (int k = 0; k < base - row; k++) {
                world.add(BodyDef.asteroid(2 * k - (base - row - 1), 1 + row * Math.sqrt(3), 1, 1));
            }
        }

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

    /** Touching balls in a row from the right wall on, the first of them at it. */
    private static World pressed(double field, double... masses) {
        World world = new World(WorldSpec.builder()
                .law(new UniformField(field, 0))
                .contacts(0.3)
                .walls(new Aabb(-3 * masses.length, -10, 0, 10), 0.3)
                .build());
        for (int k = 0; k < masses.length; k++) {
            world.add(BodyDef.asteroid(-1 - 2 * k, 0, masses[k], 1));
        }
        return world;
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

package io.github.apsis.engine.collision;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Aabb;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Circles of radius 1 at up to a million radii a tick, against closed forms. Each case runs at {@value #PHASES} phases: the hit falls
 * somewhere else in its tick each time.
 */
class BulletsTest {
    private static final int PHASES = 24;
    private static final double DT = WorldSpec.DEFAULT_DT;

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 0.1, 1, 30, 1e3, 1e6})
    void a_bullet_hits_a_resting_circle_in_its_path(double radiiPerTick) {
        double v = radiiPerTick / DT;
        for (int phase = 0; phase < PHASES; phase++) {
            World world = free();
            world.add(bullet(-2 - v * DT * (1 + share(phase)), 0, v, 0));
            world.add(BodyDef.asteroid(0, 0, 3, 1));

            run(world, 4);

            WorldSnapshot now = world.snapshot();
            assertThat(now.vx(0)).as("phase %d", phase).isCloseTo(-v / 2, within(1e-12 * v)); // (1 − 3) / (1 + 3)
            assertThat(now.vx(1)).as("phase %d", phase).isCloseTo(v / 2, within(1e-12 * v)); // 2 / (1 + 3)
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 1, 30, 1e3, 1e6})
    void two_bullets_that_cross_meet_where_their_paths_do(double radiiPerTick) {
        double v = radiiPerTick / DT;
        double contact = Math.sqrt(2); // each this far before the crossing: 2 apart, along the diagonal
        for (int phase = 0; phase < PHASES; phase++) {
            double before = contact + v * DT * (1 + share(phase));
            World world = free();
            world.add(bullet(-before, 0, v, 0));
            world.add(bullet(0, -before, 0, v));

            run(world, 4);

            WorldSnapshot now = world.snapshot();
            // Equal masses swap what they have along (1, −1)/√2: the velocities change places. A place is known to
            // 1e-16 of
            // the way flown, and the normal no better than that.
            double tolerance = 1e-14 * v * Math.max(1, radiiPerTick);
            assertThat(now.vx(0)).as("phase %d", phase).isCloseTo(0, within(tolerance));
            assertThat(now.vy(0)).as("phase %d", phase).isCloseTo(v, within(tolerance));
            assertThat(now.vx(1)).as("phase %d", phase).isCloseTo(v, within(tolerance));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 1, 30, 1e3, 1e6})
    void a_bullet_catches_up_with_a_moving_circle(double radiiPerTick) {
        double v = radiiPerTick / DT;
        for (int phase = 0; phase < PHASES; phase++) {
            World world = free();
            world.add(bullet(-2 - 0.25 * v * DT * (1 + share(phase)), 0, v, 0));
            world.add(BodyDef.asteroid(0, 0, 1, 1).moving(0.75 * v, 0));

            run(world, 4);

            assertThat(world.snapshot().vx(0)).as("phase %d", phase).isCloseTo(0.75 * v, within(1e-12 * v));
            assertThat(world.snapshot().vx(1)).as("phase %d", phase).isCloseTo(v, within(1e-12 * v));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 0.1, 1, 30, 1e3, 1e6})
    void a_graze_by_a_billionth_of_a_radius_is_a_hit(double radiiPerTick) {
        double v = radiiPerTick / DT;
        for (int phase = 0; phase < PHASES; phase++) {
            World world = free();
            world.add(bullet(-v * DT * (1 + share(phase)), 2 - 1e-9, v, 0));
            world.add(BodyDef.asteroid(0, 0, 1, 1));

            run(world, 4);

            // Closing at v √(1 − (1 − ½e-9)²) = v √(1e-9); the target leaves with that, nearly straight down.
            assertThat(world.snapshot().vy(1) / v).as("phase %d", phase).isCloseTo(-Math.sqrt(1e-9), within(1e-6));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-3, 0.1, 1, 30, 1e3, 1e6})
    void a_miss_by_a_billionth_of_a_radius_is_a_miss(double radiiPerTick) {
        double v = radiiPerTick / DT;
        for (int phase = 0; phase < PHASES; phase++) {
            World world = free();
            world.add(bullet(-v * DT * (1 + share(phase)), 2 + 1e-9, v, 0));
            world.add(BodyDef.asteroid(0, 0, 1, 1));

            run(world, 4);

            assertThat(world.snapshot().vx(0)).as("phase %d", phase).isEqualTo(v);
            assertThat(world.snapshot().vx(1)).as("phase %d", phase).isZero();
            assertThat(world.snapshot().vy(1)).as("phase %d", phase).isZero();
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 1, 30, 1e3, 1e5})
    void a_graze_is_told_from_a_miss_in_any_direction(double radiiPerTick) {
        double v = radiiPerTick / DT;
        double margin = 1e-13 * Math.max(1e4, 4 * radiiPerTick); // turned places are known to 1e-16 of the way
        for (int phase = 0; phase < PHASES; phase++) {
            double angle = 0.1 + phase * 0.2617;
            assertThat(isHit(2 - margin, v, phase, angle)).as("phase %d", phase).isTrue();
            assertThat(isHit(2 + margin, v, phase, angle)).as("phase %d", phase).isFalse();
        }
    }

    private static boolean isHit(double impactParameter, double v, int phase, double angle) {
        double c = StrictMath.cos(angle);
        double s = StrictMath.sin(angle);
        double x = -v * DT * (1 + share(phase));
        World world = free();
        world.add(bullet(c * x - s * impactParameter, s * x + c * impactParameter, c * v, s * v));
        world.add(BodyDef.asteroid(0, 0, 1, 1));

        run(world, 4);

        return world.snapshot().vx(1) != 0;
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-2, 1, 30, 1e3, 1e6})
    void nothing_that_is_a_tenth_too_wide_gets_through_between_two_fixed_circles(double radiiPerTick) {
        assertDoesNotPass(radiiPerTick, 0.1);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-2, 1, 30, 1e3, 1e6})
    void nothing_that_is_a_thousandth_too_wide_gets_through_between_two_fixed_circles(double radiiPerTick) {
        assertDoesNotPass(radiiPerTick, 1e-3);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-2, 1, 30, 1e3, 1e6})
    void nothing_that_is_a_millionth_too_wide_gets_through_between_two_fixed_circles(double radiiPerTick) {
        assertDoesNotPass(radiiPerTick, 1e-6);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-2, 1, 30, 1e3, 1e6})
    void what_is_narrow_enough_gets_through_between_two_fixed_circles(double radiiPerTick) {
        double v = radiiPerTick / DT;
        for (int phase = 0; phase < PHASES; phase++) {
            World world = gap(2 + 1e-6);
            world.add(bullet(-3 - v * DT * (1 + share(phase)), 0, v, 0));

            run(world, 4 + (long) Math.min(2000, 20 / radiiPerTick));

            assertThat(world.snapshot().vx(2)).as("phase %d", phase).isEqualTo(v);
            assertThat(world.snapshot().x(2)).as("phase %d", phase).isPositive();
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-2, 1, 30, 1e3, 1e6})
    void a_bullet_in_a_box_is_where_unfolding_puts_it(double radiiPerTick) {
        double v = radiiPerTick / DT;
        double half = 1 + Math.max(10, radiiPerTick / 8); // some four walls a tick at most
        for (int phase = 0; phase < PHASES; phase++) {
            double angle = 0.05 + 0.26 * phase;
            double vx = v * StrictMath.cos(angle);
            double vy = v * StrictMath.sin(angle);
            World world = box(half);
            world.add(bullet(0, 0, vx, vy));

            run(world, 40);

            double flown = 40 * DT;
            double tolerance = 1e-12 * (v * flown + half);
            assertThat(world.snapshot().x(0))
                    .as("phase %d", phase)
                    .isCloseTo(fold(vx * flown, half - 1), within(tolerance));
            assertThat(world.snapshot().y(0))
                    .as("phase %d", phase)
                    .isCloseTo(fold(vy * flown, half - 1), within(tolerance));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-2, 1, 30, 1e3, 1e6})
    void a_bullet_into_a_corner_comes_back_the_way_it_came(double radiiPerTick) {
        double v = radiiPerTick / DT;
        double half = 1 + Math.max(10, 3 * radiiPerTick);
        for (int phase = 0; phase < PHASES; phase++) {
            double before = v * DT * (0.5 + share(phase)); // from the place where it touches both walls
            World world = box(half);
            world.add(bullet(half - 1 - before, half - 1 - before, v, v));

            run(world, 2);

            double then = half - 1 - (2 * v * DT - before);
            assertThat(world.snapshot().vx(0)).as("phase %d", phase).isCloseTo(-v, within(1e-12 * v));
            assertThat(world.snapshot().vy(0)).as("phase %d", phase).isCloseTo(-v, within(1e-12 * v));
            assertThat(world.snapshot().x(0)).as("phase %d", phase).isCloseTo(then, within(1e-12 * half));
            assertThat(world.snapshot().y(0)).as("phase %d", phase).isCloseTo(then, within(1e-12 * half));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {30, 1e3, 1e6})
    void a_bullet_stays_in_a_small_box_and_gains_no_energy(double radiiPerTick) {
        double v = radiiPerTick / DT;
        for (int phase = 0; phase < PHASES; phase++) {
            double angle = 0.05 + 0.26 * phase;
            World world = box(5);
            world.add(bullet(0, 0, v * StrictMath.cos(angle), v * StrictMath.sin(angle)));

            for (int tick = 0; tick < 5; tick++) {
                world.step();

                WorldSnapshot now = world.snapshot();
                assertThat(Math.abs(now.x(0))).as("phase %d", phase).isLessThan(4 + 1e-6);
                assertThat(Math.abs(now.y(0))).as("phase %d", phase).isLessThan(4 + 1e-6);
                assertThat(Math.hypot(now.vx(0), now.vy(0)))
                        .as("phase %d", phase)
                        .isLessThan(v * (1 + 1e-12));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.1, 1, 9})
    void a_bullet_meets_a_circle_across_the_seam(double radiiPerTick) {
        double v = radiiPerTick / DT;
        for (int phase = 0; phase < PHASES; phase++) {
            World world = periodic();
            world.add(bullet(9.5, 0, v, 0));
            world.add(BodyDef.asteroid(-5.5 + v * DT * share(phase), 0, 1, 1)); // three and more ahead, the short way

            run(world, (long) Math.ceil(3 / radiiPerTick) + 1); // and not yet round the world

            assertThat(world.snapshot().vx(0)).as("phase %d", phase).isCloseTo(0, within(1e-12 * v));
            assertThat(world.snapshot().vx(1)).as("phase %d", phase).isCloseTo(v, within(1e-12 * v));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {11, 15, 50, 1000})
    void a_bullet_that_flies_round_the_world_in_a_tick_hits_what_is_on_its_way(double radiiPerTick) {
        double v = radiiPerTick / DT;
        for (int phase = 0; phase < PHASES; phase++) {
            double ahead = 0.3 + 15 * share(phase); // between the rims; behind the target are 16 less that
            World world = periodic();
            world.add(bullet(-9, 0, v, 0));
            world.add(BodyDef.asteroid(-7 + ahead, 0, 1, 1));

            for (int tick = 1; tick <= 4; tick++) {
                world.step();

                // The moving one flies the 16 that are free and hands on all it has, again and again.
                double flown = radiiPerTick * tick - ahead;
                boolean targetFlies = flown >= 0 && Math.floor(flown / 16) % 2 == 0;
                assertThat(world.snapshot().vx(targetFlies ? 1 : 0))
                        .as("phase %d, tick %d", phase, tick)
                        .isCloseTo(v, within(1e-12 * v));
            }
        }
    }

    /** How it comes out again may be a matter of a thousand bounces in the wedge; that it does not pass is none. */
    private static void assertDoesNotPass(double radiiPerTick, double tooWide) {
        double v = radiiPerTick / DT;
        for (int phase = 0; phase < PHASES; phase++) {
            World world = gap(2 - tooWide);
            world.add(bullet(-3 - v * DT * (1 + share(phase)), 0, v, 0));

            run(world, 4 + (long) Math.min(2000, 20 / radiiPerTick));

            assertThat(world.snapshot().x(2)).as("phase %d", phase).isNegative();
        }
    }

    private static double share(int phase) {
        return (double) phase / PHASES;
    }

    private static BodyDef bullet(double x, double y, double vx, double vy) {
        return BodyDef.asteroid(x, y, 1, 1).moving(vx, vy);
    }

    private static World free() {
        return new World(WorldSpec.builder().contacts(1).build());
    }

    private static World box(double half) {
        return new World(WorldSpec.builder().walls(Aabb.centred(half, half), 1).build());
    }

    private static World periodic() {
        return new World(
                WorldSpec.builder().contacts(1).periodic(Aabb.centred(10, 10)).build());
    }

    /** Two fixed circles of radius 1 above each other. */
    private static World gap(double width) {
        World world = free();
        world.add(BodyDef.asteroid(0, 1 + width / 2, 1, 1).fixed());
        world.add(BodyDef.asteroid(0, -1 - width / 2, 1, 1).fixed());
        return world;
    }

    /** The place of a point that runs to and fro between −half and half, unfolded. */
    private static double fold(double x, double half) {
        double turned = (x + half) - 4 * half * Math.floor((x + half) / (4 * half));
        return turned <= 2 * half ? turned - half : 3 * half - turned;
    }
}

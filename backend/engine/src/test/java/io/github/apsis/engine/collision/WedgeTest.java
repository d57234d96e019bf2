package io.github.apsis.engine.collision;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Aabb;
import java.util.BitSet;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** A heavy ball drives a light one between two fixed circles: it stops, or comes back, and nothing flies off with energy from nowhere. */
class WedgeTest {
    private static final int PHASES = 24;

    static Stream<Arguments> drives() {
        return Stream.of(0.0, 0.5, 1.0).flatMap(e -> Stream.of(1.0, 1e3, 1e6)
                .flatMap(heavy -> Stream.of(1.0, 30.0, 1e3).map(v -> Arguments.of(e, heavy, v))));
    }

    /** Of energy, as a share: speeds, normal and impulse are each right to half a unit in the last place, and enter squared. */
    private static final double ROUNDING_OF_A_BOUNCE = 4e-16;

    @ParameterizedTest
    @MethodSource("drives")
    void a_ball_that_is_driven_into_a_wedge_does_not_leave_with_more_than_drove_it(double e, double heavy, double v) {
        for (int phase = 0; phase < PHASES; phase++) {
            double aside = 0.02 * phase; // of the line through the wedge
            World world = new World(WorldSpec.builder().contacts(e).build());
            world.add(BodyDef.asteroid(0, 1.5, 1, 1).fixed());
            world.add(BodyDef.asteroid(0, -1.5, 1, 1).fixed());
            world.add(BodyDef.asteroid(-1.4, 0.01, 1, 1));
            world.add(BodyDef.asteroid(-4 - 0.07 * phase, aside, heavy, 1).moving(v, 0));
            double start = world.conserved().kinetic();

            for (int tick = 0; tick < 150; tick++) {
                world.step();
                assertThat(world.conserved().kinetic())
                        .as("phase %d, tick %d", phase, tick)
                        .isLessThanOrEqualTo(start * (1 + 1e-12));
            }
            assertThat(deepest(world)).as("overlap, radii, phase %d", phase).isLessThan(0.01);
        }
    }

    @ParameterizedTest
    @MethodSource("edges")
    void a_light_ball_pinched_by_a_heavy_one_is_not_shot_out(Boundary edge) {
        List<BodyDef> bodies = List.of(
                BodyDef.asteroid(-2.36, 2.48, 64.5, 0.451).fixed(),
                BodyDef.asteroid(-2.02, 1.68, 0.22, 0.422).moving(0.53, 0.207),
                BodyDef.asteroid(-2.79, 0.925, 0.0017, 0.503).fixed(),
                BodyDef.asteroid(-1.32, 0.646, 35_500, 0.389).moving(-15, 21.3));
        WorldSpec.Builder laws = WorldSpec.builder().contacts(0);
        World world = new World((edge instanceof Boundary.Periodic p ? laws.periodic(p.box()) : laws).build());
        bodies.forEach(world::add);
        double start = world.conserved().kinetic();

        for (int tick = 0; tick < 150; tick++) {
            world.step();
            assertThat(world.conserved().kinetic()).as("tick %d", tick).isLessThanOrEqualTo(start * (1 + 1e-12));
        }
    }

    @ParameterizedTest
    @MethodSource("drives")
    void a_ball_that_is_driven_into_a_corner_does_not_leave_with_more_than_drove_it(double e, double heavy, double v) {
        for (int phase = 0; phase < PHASES; phase += 4) {
            World world = new World(WorldSpec.builder()
                    .contacts(e)
                    .walls(Aabb.centred(3.3, 3.3), 1)
                    .build());
            world.add(BodyDef.asteroid(2.1, -2.2, 1, 1));
            double angle = -1.2 + 0.05 * phase;
            world.add(BodyDef.asteroid(-1, 1, heavy, 1).moving(v * StrictMath.cos(angle), v * StrictMath.sin(angle)));
            double start = world.conserved().kinetic();
            var bounces = new AtomicInteger();
            world.onBounce((time, first, second, closing, impulse) -> bounces.incrementAndGet());

            for (int tick = 0; tick < 30; tick++) {
                world.step();
                double rounding = ROUNDING_OF_A_BOUNCE * (1 + bounces.get());
                assertThat(world.conserved().kinetic())
                        .as("phase %d, tick %d, %s bounces", phase, tick, bounces)
                        .isLessThanOrEqualTo(start * (1 + rounding));
            }
        }
    }

    static Stream<Boundary> edges() {
        return Stream.of(new Boundary.Open(), new Boundary.Periodic(Aabb.centred(5, 5)));
    }

    /** The first two are fixed and may stand as they like. */
    private static double deepest(World world) {
        WorldSnapshot now = world.snapshot();
        BitSet fixed = new BitSet();
        fixed.set(0, 2);
        return Depth.ofPairs(now, world.spec().boundary(), fixed::get, i -> false);
    }
}

package io.github.apsis.engine.collision;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.collision.Boundary.HalfPlane;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class HalfPlanesTest {
    private static final double HALF = Math.sqrt(0.5);

    @Test
    void a_ball_that_falls_on_a_slope_of_45_degrees_flies_off_sideways() {
        World world = new World(WorldSpec.builder()
                .halfPlanes(List.of(new HalfPlane(HALF, HALF, 0)), 1)
                .build());
        world.add(BodyDef.asteroid(0, 3, 1, 0.5).moving(0, -2));

        run(world, 300); // 2 s: the slope is touched at y = √2/2, after 1.15 s

        WorldSnapshot now = world.snapshot();
        assertThat(now.vx(0)).isCloseTo(2, within(1e-14));
        assertThat(now.vy(0)).isCloseTo(0, within(1e-14));
        assertThat(now.y(0)).isCloseTo(HALF, within(1e-13));
        assertThat(now.x(0)).isCloseTo(4 - (3 - HALF), within(1e-13)); // the way is 4 long
    }

    @Test
    void a_ball_slides_down_a_slope_with_g_times_its_sine() {
        World world = new World(WorldSpec.builder()
                .law(new UniformField(0, -10))
                .halfPlanes(List.of(new HalfPlane(0.6, 0.8, 0)), 0)
                .build());
        world.add(BodyDef.asteroid(0.6, 0.8, 1, 1));

        run(world, 300);

        WorldSnapshot now = world.snapshot();
        double along = 10 * 0.6 * 2 * 2 / 2; // g sin α t²/2
        // Frictionless, and the field is uniform: only the slop of the contact remains.
        assertThat(0.8 * now.x(0) - 0.6 * now.y(0)).isCloseTo(along, within(1e-6));
        assertThat(0.6 * now.x(0) + 0.8 * now.y(0)).isCloseTo(1, within(1e-6));
    }

    @Test
    void four_half_planes_are_a_box_to_the_bit() {
        var box = Aabb.centred(8, 6);
        World inBox = gas(WorldSpec.builder().contacts(0.9).walls(box, 0.8).build());
        World inPlanes = gas(WorldSpec.builder()
                .contacts(0.9)
                .halfPlanes(
                        List.of(
                                new HalfPlane(1, 0, box.minX()),
                                new HalfPlane(-1, 0, -box.maxX()),
                                new HalfPlane(0, 1, box.minY()),
                                new HalfPlane(0, -1, -box.maxY())),
                        0.8)
                .build());

        run(inBox, 1500);
        run(inPlanes, 1500);

        assertThat(inPlanes.stateHash()).isEqualTo(inBox.stateHash());
    }

    @Test
    void a_listener_hears_every_bounce_with_its_time_and_its_wall() {
        World world = new World(WorldSpec.builder()
                .contacts(1)
                .halfPlanes(List.of(new HalfPlane(0, 1, 0), new HalfPlane(-1, 0, -10)), 0.5)
                .build());
        long left = world.add(BodyDef.asteroid(0, 5, 1, 1).moving(2, 0)).value();
        long right = world.add(BodyDef.asteroid(5, 5, 1, 1)).value();
        List<String> heard = new ArrayList<>();
        world.onBounce((time, first, second, closing, impulse) ->
                heard.add("%.9f %d %d %.9f %.9f".formatted(time, first, second, closing, impulse)));

        run(world, 600);

        assertThat(heard)
                .containsExactly(
                        "1.500000000 %d %d 2.000000000 2.000000000".formatted(left, right),
                        "3.500000000 %d -2 2.000000000 3.000000000".formatted(right));
    }

    @Test
    void a_normal_that_is_no_unit_vector_is_refused() {
        assertThatThrownBy(() -> new HalfPlane(1, 1, 0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("length 1");
    }

    private static World gas(WorldSpec spec) {
        World world = new World(spec);
        for (int i = 0; i < 12; i++) {
            world.add(BodyDef.asteroid(-3 + 2 * (i % 4), -2 + 2 * (i / 4), 1 + i, 0.4)
                    .moving(3 - i, i - 5));
        }
        return world;
    }
}

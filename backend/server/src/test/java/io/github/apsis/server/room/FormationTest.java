package io.github.apsis.server.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Vec2;
import java.util.List;
import org.junit.jupiter.api.Test;

class FormationTest {
    private static final double RADIUS = 4;
    private static final Boundary OPEN = new Boundary.Open();
    private static final Boundary WALLS = new Boundary.Walls(Aabb.centred(100, 100), 1);

    @Test
    void the_first_goes_to_the_very_point() {
        assertThat(Formation.around(new Vec2(3, 7), 1, RADIUS, OPEN)).containsExactly(new Vec2(3, 7));
    }

    @Test
    void six_stand_around_the_first_and_touch_nobody() {
        List<Vec2> slots = Formation.around(new Vec2(0, 0), 7, RADIUS, OPEN);

        assertThat(slots.subList(1, 7))
                .allSatisfy(slot -> assertThat(slot.length()).isCloseTo(10, within(1e-9))); // 2.5 radii
        assertThat(closest(slots)).isCloseTo(10, within(1e-9));
    }

    @Test
    void a_hundred_keep_their_distance() {
        List<Vec2> slots = Formation.around(new Vec2(0, 0), 100, RADIUS, OPEN);

        assertThat(slots).hasSize(100);
        assertThat(closest(slots)).isCloseTo(10, within(1e-9));
    }

    @Test
    void nobody_is_sent_into_a_wall() {
        List<Vec2> slots = Formation.around(new Vec2(100, 100), 30, RADIUS, WALLS);

        assertThat(slots.get(0)).isEqualTo(new Vec2(96, 96)); // a rim cannot come closer
        assertThat(slots).allSatisfy(slot -> {
            assertThat(Math.abs(slot.x())).isLessThanOrEqualTo(96);
            assertThat(Math.abs(slot.y())).isLessThanOrEqualTo(96);
        });
        assertThat(closest(slots)).isCloseTo(10, within(1e-9));
    }

    @Test
    void a_formation_goes_on_beyond_the_edge_of_a_periodic_world() {
        Boundary periodic = new Boundary.Periodic(Aabb.centred(100, 100));

        List<Vec2> slots = Formation.around(new Vec2(99, 0), 7, RADIUS, periodic);

        assertThat(slots).allSatisfy(slot -> assertThat(Aabb.centred(100, 100).contains(slot.x(), slot.y()))
                .isTrue());
        assertThat(slots).anySatisfy(slot -> assertThat(slot.x()).isCloseTo(-91, within(1e-9)));
    }

    @Test
    void in_a_world_too_small_everybody_gets_the_middle() {
        Boundary tiny = new Boundary.Walls(Aabb.centred(1, 1), 1);

        assertThat(Formation.around(new Vec2(1, 1), 3, RADIUS, tiny)).hasSize(3).containsOnly(new Vec2(0, 0));
    }

    private static double closest(List<Vec2> slots) {
        double closest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < slots.size(); i++) {
            for (int j = 0; j < i; j++) {
                Vec2 a = slots.get(i);
                Vec2 b = slots.get(j);
                closest = Math.min(closest, Math.hypot(a.x() - b.x(), a.y() - b.y()));
            }
        }
        return closest;
    }
}

package io.github.apsis.engine.spatial;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.math.Rng;
import io.github.apsis.engine.parallel.Team;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CircleGridTest {
    private static final Aabb WORLD = new Aabb(-300, 100, 700, 700); // of those that repeat themselves
    private static final double LARGEST_IN_PERIOD = 149; // a quarter of its height

    /** One circle: x, y, radius. */
    private record Circle(double x, double y, double r) {}

    /** How radii are spread. */
    private enum Radii {
        EQUAL,
        FROM_A_HUNDREDTH_TO_A_HUNDRED,
        MOSTLY_POINTS,
        DUST_AND_A_GIANT;

        double draw(Rng rng) {
            return switch (this) {
                case EQUAL -> 2;
                case FROM_A_HUNDREDTH_TO_A_HUNDRED -> StrictMath.pow(10, rng.between(-2, 2));
                case MOSTLY_POINTS -> rng.nextDouble() < 0.9 ? 0 : rng.between(0, 10);
                case DUST_AND_A_GIANT -> rng.nextDouble() < 0.002 ? LARGEST_IN_PERIOD : 1e-3;
            };
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 5, 40, 300, 2000})
    void finds_exactly_the_pairs_that_a_look_at_every_pair_finds(int count) {
        for (Radii radii : Radii.values()) {
            for (Period period : periods()) {
                for (long seed = 1; seed <= 5; seed++) {
                    List<Circle> circles = circles(count, radii, new Rng(seed));

                    CircleGrid grid = grid(circles, period);

                    assertThat(pairs(grid))
                            .as("%s, seed %d, %s", radii, seed, period == null ? "open" : "periodic")
                            .isEqualTo(touching(circles, period));
                }
            }
        }
    }

    @Test
    void a_team_finds_the_same_pairs() {
        try (Team team = new Team(3)) {
            for (Radii radii : Radii.values()) {
                for (Period period : periods()) {
                    List<Circle> circles = circles(5000, radii, new Rng(7)); // fewer are left to one thread

                    assertThat(pairs(filled(new CircleGrid(period, team, new Workspace()), circles)))
                            .as("%s, %s", radii, period == null ? "open" : "periodic")
                            .isEqualTo(pairs(grid(circles, period)));
                }
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 40, 300, 2000})
    void finds_exactly_what_touches_a_circle_after_any_have_moved_and_grown(int count) {
        for (Radii radii : Radii.values()) {
            for (Period period : periods()) {
                var rng = new Rng(count);
                List<Circle> circles = circles(count, radii, rng);
                CircleGrid grid = grid(circles, period);
                for (int step = 0; step < 500; step++) {
                    int i = rng.nextInt(count);
                    Circle old = circles.get(i);
                    // Most stay near, some go anywhere.
                    Circle changed = step % 3 == 0
                            ? circles(1, radii, rng).get(0)
                            : new Circle(old.x + rng.between(-1, 1), old.y + rng.between(-1, 1), 1.1 * old.r);
                    circles.set(i, changed);
                    grid.move(i, changed.x, changed.y, changed.r);

                    int asked = step % 2 == 0 ? i : rng.nextInt(count);

                    assertThat(found(grid, asked))
                            .as("%s, step %d, %s", radii, step, period == null ? "open" : "periodic")
                            .isEqualTo(touching(circles.get(asked), circles, period));
                }
            }
        }
    }

    @Test
    void finds_neighbours_however_far_from_the_origin_and_from_the_others_they_are() {
        for (double place : new double[] {1e3, 1e9, 1e15, 1e100, 1e150}) {
            double size = 1e-9 * place;
            var circles = new ArrayList<>(circles(500, Radii.EQUAL, new Rng(5)));
            circles.add(new Circle(place, -place, size));
            circles.add(new Circle(place + 1.5 * size, -place, size));
            circles.add(new Circle(place + 4 * size, -place, size));

            CircleGrid grid = grid(circles, null);

            assertThat(pairs(grid)).as("at %s", place).contains("500 501").doesNotContain("501 502", "0 500");
        }
    }

    @Test
    void holds_a_thousand_circles_on_one_spot() {
        List<Circle> circles = Collections.nCopies(1000, new Circle(1, 1, 0));

        assertThat(grid(circles, null).findPairs()).isEqualTo(1000 * 999 / 2);
    }

    @Test
    void finds_circles_across_the_seam_and_across_its_corner() {
        var period = new Period(new Aabb(0, 0, 100, 100));
        List<Circle> circles =
                List.of(new Circle(1, 1, 2), new Circle(99, 50, 2), new Circle(1, 51, 2), new Circle(98, 99, 2));

        assertThat(pairs(grid(circles, period))).containsExactly("0 3", "1 2");
    }

    @Test
    void finds_a_circle_as_wide_as_its_world_once() {
        var period = new Period(new Aabb(0, 0, 10, 10));
        List<Circle> circles = List.of(new Circle(1, 1, 20), new Circle(9, 5, 20), new Circle(5, 5, 0.1));

        assertThat(pairs(grid(circles, period))).containsExactly("0 1", "0 2", "1 2");
    }

    private static List<@Nullable Period> periods() {
        return Arrays.asList(null, new Period(WORLD));
    }

    private static List<Circle> circles(int count, Radii radii, Rng rng) {
        List<Circle> circles = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double x = rng.between(WORLD.minX(), WORLD.maxX());
            double y = rng.between(WORLD.minY(), WORLD.maxY());
            circles.add(new Circle(x, y, radii.draw(rng)));
        }
        return circles;
    }

    private static CircleGrid grid(List<Circle> circles, @Nullable Period period) {
        return filled(new CircleGrid(period), circles);
    }

    private static CircleGrid filled(CircleGrid grid, List<Circle> circles) {
        grid.begin(circles.size());
        for (int i = 0; i < circles.size(); i++) {
            grid.set(i, circles.get(i).x, circles.get(i).y, circles.get(i).r);
        }
        grid.build();
        return grid;
    }

    private static List<String> pairs(CircleGrid grid) {
        List<String> pairs = new ArrayList<>();
        int count = grid.findPairs();
        for (int k = 0; k < count; k++) {
            assertThat(grid.first(k)).isLessThan(grid.second(k));
            pairs.add(grid.first(k) + " " + grid.second(k));
        }
        Collections.sort(pairs);
        return pairs;
    }

    private static List<Integer> found(CircleGrid grid, int asked) {
        List<Integer> found = new ArrayList<>();
        int hits = grid.query(asked);
        for (int hit = 0; hit < hits; hit++) {
            found.add(grid.found(hit));
        }
        Collections.sort(found);
        return found;
    }

    private static List<String> touching(List<Circle> circles, @Nullable Period period) {
        List<String> pairs = new ArrayList<>();
        for (int i = 0; i < circles.size(); i++) {
            for (int j = i + 1; j < circles.size(); j++) {
                if (touch(circles.get(i), circles.get(j), period)) {
                    pairs.add(i + " " + j);
                }
            }
        }
        Collections.sort(pairs);
        return pairs;
    }

    private static List<Integer> touching(Circle asked, List<Circle> circles, @Nullable Period period) {
        List<Integer> found = new ArrayList<>();
        for (int i = 0; i < circles.size(); i++) {
            if (touch(asked, circles.get(i), period)) {
                found.add(i);
            }
        }
        return found;
    }

    private static boolean touch(Circle a, Circle b, @Nullable Period period) {
        double dx = b.x - a.x;
        double dy = b.y - a.y;
        if (period != null) {
            dx = period.nearestX(dx);
            dy = period.nearestY(dy);
        }
        return dx * dx + dy * dy <= (a.r + b.r) * (a.r + b.r);
    }
}

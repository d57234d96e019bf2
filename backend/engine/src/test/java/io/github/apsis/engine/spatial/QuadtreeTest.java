package io.github.apsis.engine.spatial;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.math.Rng;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class QuadtreeTest {
    private final Quadtree tree = new Quadtree();

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 8, 9, 100, 3000})
    void finds_exactly_what_a_look_at_every_box_finds(int count) {
        long seed = 11 + count;
        var rng = new Rng(seed);
        double[][] boxes = new double[count][];
        for (int i = 0; i < count; i++) {
            double x = rng.between(-100, 100);
            double y = rng.between(-100, 100);
            double r = rng.nextDouble() < 0.01 ? 50 : rng.between(0, 3); // a few giants among the small
            boxes[i] = new double[] {x - r, y - r, x + r, y + r};
        }
        build(boxes);

        for (int query = 0; query < 200; query++) {
            double x = rng.between(-120, 120);
            double y = rng.between(-120, 120);
            double r = rng.between(0, 20);
            int[] expected = touching(boxes, x - r, y - r, x + r, y + r);

            assertThat(query(x - r, y - r, x + r, y + r))
                    .as("seed %d, query %d", seed, query)
                    .isEqualTo(expected);
        }
    }

    @Test
    void holds_a_thousand_boxes_on_one_spot() {
        double[][] boxes = new double[1000][];
        Arrays.setAll(boxes, i -> new double[] {1, 1, 1, 1});
        build(boxes);

        assertThat(query(1, 1, 1, 1)).hasSize(1000);
        assertThat(query(2, 2, 3, 3)).isEmpty();
    }

    @Test
    void tells_neighbours_apart_that_are_one_ulp_apart_beside_one_far_away() {
        double near = Math.nextUp(1.0);
        build(new double[][] {{1, 1, 1, 1}, {near, 1, near, 1}, {1e15, 1e15, 1e15, 1e15}});

        assertThat(query(near, 1, 2, 1)).containsExactly(1);
    }

    @Test
    void a_crowd_beside_one_far_away_is_sorted_anew_within_its_own_box() {
        var rng = new Rng(5);
        double[][] boxes = new double[5001][];
        Arrays.setAll(boxes, i -> {
            double x = i == 2500 ? 1e12 : rng.between(0, 1);
            double y = rng.between(0, 1);
            return new double[] {x, y, x, y};
        });
        build(boxes);

        for (int i = 0; i < 100; i++) {
            double x = rng.between(0, 1);
            double y = rng.between(0, 1);
            assertThat(query(x, y, x + 0.1, y + 0.1)).isEqualTo(touching(boxes, x, y, x + 0.1, y + 0.1));
        }
    }

    @Test
    void can_be_built_again_with_fewer_items() {
        build(new double[][] {{0, 0, 1, 1}, {5, 5, 6, 6}});
        build(new double[][] {{8, 8, 9, 9}});

        assertThat(query(0, 0, 10, 10)).containsExactly(0);
    }

    private void build(double[][] boxes) {
        tree.begin(boxes.length);
        for (int i = 0; i < boxes.length; i++) {
            tree.set(i, boxes[i][0], boxes[i][1], boxes[i][2], boxes[i][3]);
        }
        tree.build();
    }

    private int[] query(double minX, double minY, double maxX, double maxY) {
        int[] found = new int[tree.query(minX, minY, maxX, maxY)];
        Arrays.setAll(found, tree::found);
        Arrays.sort(found);
        return found;
    }

    private static int[] touching(double[][] boxes, double minX, double minY, double maxX, double maxY) {
        return java.util.stream.IntStream.range(0, boxes.length)
                .filter(i -> boxes[i][0] <= maxX && boxes[i][2] >= minX && boxes[i][1] <= maxY && boxes[i][3] >= minY)
                .toArray();
    }
}

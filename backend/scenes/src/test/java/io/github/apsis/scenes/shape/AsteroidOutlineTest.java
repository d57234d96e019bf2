package io.github.apsis.scenes.shape;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.math.Rng;
import java.math.BigDecimal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AsteroidOutlineTest {
    private static final int MANY = 2000;

    @ParameterizedTest
    @ValueSource(doubles = {3e-6, 0.7, 1, 2.5, 9.99, 11, 4000})
    void the_wanted_circle_encloses_every_vertex(double radius) {
        for (long seed = 0; seed < MANY; seed++) {
            Outline outline = AsteroidOutline.random(new Rng(seed), radius);

            for (int i = 0; i < outline.count(); i++) {
                double reach = Math.sqrt(square(outline.x(i)) + square(outline.y(i)));
                assertThat(reach).as("seed %d, vertex %d", seed, i).isLessThanOrEqualTo(radius);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {3e-6, 1, 7.3})
    void the_smallest_circle_about_it_is_the_wanted_one(double radius) {
        for (long seed = 0; seed < MANY; seed++) {
            Outline outline = AsteroidOutline.random(new Rng(seed), radius);

            // Cutting to a thousandth moves a vertex inwards by √2 thousandths at most.
            assertThat(AsteroidOutline.enclosingRadius(outline))
                    .as("seed %d", seed)
                    .isCloseTo(radius, within(1.5e-3 * radius));
        }
    }

    @Test
    void has_7_to_12_vertices_and_turns_left_at_each() {
        for (long seed = 0; seed < MANY; seed++) {
            Outline outline = AsteroidOutline.random(new Rng(seed), 5);

            assertThat(outline.count()).as("seed %d", seed).isBetween(7, 12);
            for (int i = 0; i < outline.count(); i++) {
                assertThat(turn(outline, i)).as("seed %d, vertex %d", seed, i).isPositive();
            }
        }
    }

    @Test
    void its_area_lies_between_that_of_a_flat_and_of_a_full_disc() {
        for (long seed = 0; seed < MANY; seed++) {
            double area = AsteroidOutline.area(AsteroidOutline.random(new Rng(seed), 5));

            assertThat(area / (Math.PI * 25)).as("seed %d", seed).isBetween(0.45, 0.98);
        }
    }

    @Test
    void the_area_of_a_square_is_its_side_squared() {
        assertThat(AsteroidOutline.area(new Outline(new double[] {1, 1, -1, 1, -1, -1, 1, -1})))
                .isEqualTo(4);
    }

    @Test
    void its_coordinates_are_short() {
        Outline outline = AsteroidOutline.random(new Rng(4), 7.25);

        for (int i = 0; i < outline.count(); i++) {
            assertThat(BigDecimal.valueOf(outline.x(i)).scale()).isLessThanOrEqualTo(3);
            assertThat(BigDecimal.valueOf(outline.y(i)).scale()).isLessThanOrEqualTo(3);
        }
    }

    @Test
    void the_same_seed_gives_the_same_outline_and_another_seed_another() {
        String outline = AsteroidOutline.random(new Rng(1), 5).toString();

        assertThat(AsteroidOutline.random(new Rng(1), 5)).hasToString(outline);
        assertThat(AsteroidOutline.random(new Rng(2), 5).toString()).isNotEqualTo(outline);
    }

    @Test
    void an_outline_needs_a_size() {
        assertThatThrownBy(() -> AsteroidOutline.random(new Rng(1), 0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("radius must be positive");
    }

    /** Cross product of the edges before and after a vertex. */
    private static double turn(Outline outline, int vertex) {
        int before = (vertex + outline.count() - 1) % outline.count();
        int after = (vertex + 1) % outline.count();
        return (outline.x(vertex) - outline.x(before)) * (outline.y(after) - outline.y(vertex))
                - (outline.y(vertex) - outline.y(before)) * (outline.x(after) - outline.x(vertex));
    }

    private static double square(double length) {
        return length * length;
    }
}

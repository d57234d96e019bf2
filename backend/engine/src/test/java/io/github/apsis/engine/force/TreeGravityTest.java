package io.github.apsis.engine.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Rng;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TreeGravityTest {
    private final TreeGravity tree = new TreeGravity(1, 0, 0.5);

    @ParameterizedTest
    @ValueSource(doubles = {0, -0.5, 1.1, Double.NaN})
    void an_opening_angle_lies_between_0_and_1(double theta) {
        assertThatThrownBy(() -> new TreeGravity(1, 0, theta))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("theta must be above 0 and at most 1, was " + theta);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 32, 33, 100})
    void few_bodies_are_summed_as_by_the_direct_sum(int count) {
        Bodies bodies = cloud(count);
        Bodies direct = cloud(count);

        new TreeGravity(1, 0, 1e-6).apply(bodies);
        new DirectGravity(1, 0).apply(direct);

        for (int i = 0; i < count; i++) {
            assertThat(bodies.ax(i)).isCloseTo(direct.ax(i), within(1e-13 * Math.abs(direct.ax(i)) + 1e-13));
            assertThat(bodies.ay(i)).isCloseTo(direct.ay(i), within(1e-13 * Math.abs(direct.ay(i)) + 1e-13));
        }
    }

    @Test
    void a_thousand_bodies_on_one_spot_do_not_pull_each_other() {
        var bodies = new Bodies();
        for (int i = 0; i < 1000; i++) {
            bodies.add(BodyDef.planet(0.1, 0.1, 1e30, 0));
        }

        tree.apply(bodies);

        for (int i = 0; i < 1000; i++) {
            assertThat(bodies.ax(i)).isZero();
            assertThat(bodies.ay(i)).isZero();
        }
    }

    @Test
    void a_thousand_bodies_one_ulp_apart_pull_each_other_by_finite_amounts() {
        var bodies = new Bodies();
        for (int i = 0; i < 1000; i++) {
            bodies.add(BodyDef.planet(0.1 + i * 0x1p-56, 0.1, 1, 0));
        }

        tree.apply(bodies);

        assertFinite(bodies);
        assertThat(bodies.ax(0)).isPositive();
        // In an even row the pulls of neighbours cancel: what is left is a hundredth of what was added up.
        assertThat(ForceCase.netForce(bodies)).isLessThan(1e-13);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e45, 1e103, 1e160, 1e300})
    void a_body_far_beyond_all_others_does_not_disturb_them(double distance) {
        Bodies bodies = cloud(1000);
        Bodies alone = cloud(1000);
        bodies.add(BodyDef.planet(distance, -distance, 1, 0));

        tree.apply(bodies);
        new DirectGravity(1, 0).apply(alone);

        assertFinite(bodies);
        for (int i = 0; i < 1000; i++) {
            double size = Math.hypot(alone.ax(i), alone.ay(i));
            assertThat(bodies.ax(i)).isCloseTo(alone.ax(i), within(0.1 * size)); // as good as the tree without it
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-160, 1e-110, 1e-90, 1e-45, 1e45, 1e110, 1e160, 8e307})
    void no_scale_of_lengths_leaves_the_numbers(double scale) {
        var rng = new Rng(5);
        var bodies = new Bodies();
        for (int i = 0; i < 300; i++) {
            bodies.add(BodyDef.planet(rng.between(-scale, scale), rng.between(-scale, scale), 1, 0));
        }

        tree.apply(bodies);

        assertFinite(bodies);
    }

    @Test
    void the_mirror_image_of_a_world_is_pulled_in_mirror_image() {
        Bodies bodies = cloud(2000);
        var mirrored = new Bodies();
        for (int i = 0; i < bodies.count(); i++) {
            mirrored.add(BodyDef.planet(bodies.x(i), -bodies.y(i), bodies.mass(i), 0));
        }

        tree.apply(bodies);
        tree.apply(mirrored);

        // The cells are cut elsewhere, so the errors differ; nothing else does.
        for (int i = 0; i < bodies.count(); i++) {
            double size = Math.hypot(bodies.ax(i), bodies.ay(i));
            assertThat(mirrored.ax(i)).isCloseTo(bodies.ax(i), within(0.1 * size));
            assertThat(mirrored.ay(i)).isCloseTo(-bodies.ay(i), within(0.1 * size));
        }
    }

    @Test
    void the_order_in_which_bodies_were_added_changes_nothing_but_rounding() {
        Bodies bodies = cloud(2000);
        var reversed = new Bodies();
        for (int i = bodies.count() - 1; i >= 0; i--) {
            reversed.add(BodyDef.planet(bodies.x(i), bodies.y(i), bodies.mass(i), 0));
        }

        tree.apply(bodies);
        tree.apply(reversed);

        // Sums of pulls up to 4e6, half an ulp of which is 5e-10, in another order within a leaf.
        for (int i = 0; i < bodies.count(); i++) {
            double rounding = 1e-9 + 1e-14 * Math.abs(bodies.ax(i));
            assertThat(reversed.ax(bodies.count() - 1 - i)).isCloseTo(bodies.ax(i), within(rounding));
        }
    }

    @Test
    void the_same_bodies_give_the_same_bits_whatever_was_computed_before() {
        Bodies first = cloud(3000);
        Bodies again = cloud(3000);

        tree.apply(first);
        tree.apply(cloud(5000));
        tree.apply(again);

        assertThat(again.hash()).isEqualTo(first.hash());
    }

    private static void assertFinite(Bodies bodies) {
        for (int i = 0; i < bodies.count(); i++) {
            assertThat(bodies.ax(i)).isFinite();
            assertThat(bodies.ay(i)).isFinite();
        }
    }

    private static Bodies cloud(int count) {
        var rng = new Rng(3);
        var bodies = new Bodies();
        for (int i = 0; i < count; i++) {
            bodies.add(BodyDef.planet(rng.between(-1, 1), rng.between(-1, 1), rng.between(0.1, 2), 0));
        }
        return bodies;
    }
}

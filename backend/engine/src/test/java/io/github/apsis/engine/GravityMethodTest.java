package io.github.apsis.engine;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.force.GravitySolver;
import io.github.apsis.engine.force.GravitySolver.Method;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class GravityMethodTest {
    @Test
    void gravity_is_summed_directly_unless_a_spec_says_otherwise() {
        assertThat(new World(gravity().build()).gravitySolver()).isEqualTo(GravitySolver.of(Method.DIRECT, 0));
        assertThat(new World(gravity().tree(0.4).build()).gravitySolver())
                .isEqualTo(GravitySolver.of(Method.TREE, 0.4));
        assertThat(new World(WorldSpec.builder().build()).gravitySolver()).isEqualTo(GravitySolver.of(Method.NONE, 0));
    }

    @Test
    void a_tree_needs_gravity_and_no_period() {
        var periodic = gravity().periodic(Aabb.centred(10, 10)).tree(0.5);
        var weightless = WorldSpec.builder().forceError(1e-3);

        assertThatThrownBy(periodic::build)
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("a periodic world sums nearest images");
        assertThatThrownBy(weightless::build)
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("need gravity");
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, 1, Double.NaN})
    void an_impossible_force_error_is_named(double error) {
        assertThatThrownBy(() -> gravity().forceError(error))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("a force error must be above 0 and below 1, was " + error);
    }

    @Test
    void few_bodies_are_summed_directly_whatever_error_is_allowed() {
        World world = cluster(gravity().forceError(0.1).build(), 100);

        run(world, 3);

        assertThat(world.gravitySolver().method()).isEqualTo(Method.DIRECT);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-2, 1e-3, 1e-4})
    void many_bodies_keep_the_error_by_a_tree(double allowed) {
        World world = cluster(gravity().softening(0.01).forceError(allowed).build(), 4000);

        world.step();

        GravitySolver solver = world.gravitySolver();
        assertThat(solver.method()).isEqualTo(Method.TREE);
        assertThat(solver.sampledError().orElseThrow()).isLessThan(allowed);
        assertThat(world.forceError().orElseThrow().ninetieth()).isLessThan(1.5 * allowed); // one tick later
    }

    @Test
    void an_error_near_rounding_leaves_only_the_direct_sum() {
        World world = cluster(gravity().softening(0.01).forceError(1e-13).build(), 1000);

        world.step();

        assertThat(world.gravitySolver().method()).isEqualTo(Method.DIRECT);
        assertThat(world.forceError().orElseThrow().ninetieth()).isLessThan(1e-14);
    }

    @Test
    void a_larger_allowed_error_opens_the_tree_wider() {
        World coarse = cluster(gravity().softening(0.01).forceError(1e-2).build(), 3000);
        World fine = cluster(gravity().softening(0.01).forceError(1e-4).build(), 3000);
        coarse.step();
        fine.step();

        assertThat(coarse.gravitySolver().theta())
                .isGreaterThan(fine.gravitySolver().theta());
    }

    @Test
    void looking_at_a_world_does_not_change_its_history() {
        WorldSpec spec = gravity().softening(0.01).forceError(1e-3).build();
        World watched = cluster(spec, 1000);
        World alone = cluster(spec, 1000);

        for (int i = 0; i < 130; i++) { // past two looks of the solver at its error
            watched.snapshot();
            watched.forceError();
            watched.step();
            alone.step();
        }

        assertThat(watched.stateHash()).isEqualTo(alone.stateHash());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.3, 0.7})
    void a_softened_cluster_keeps_its_energy_under_the_tree_as_under_the_direct_sum(double theta) {
        World tree = cluster(gravity().softening(0.05).tree(theta).build(), 1000);
        World direct = cluster(gravity().softening(0.05).build(), 1000);
        double before = direct.conserved().energy().orElseThrow();

        run(tree, 300);
        run(direct, 300);

        double drift = (direct.conserved().energy().orElseThrow() - before) / Math.abs(before);
        double treeDrift = (tree.conserved().energy().orElseThrow() - before) / Math.abs(before);
        assertThat(Math.abs(drift)).isLessThan(1e-3);
        // The median error of the pull is 1e-6 at 0.3 and 4e-4 at 0.7, and the errors of 300 ticks partly cancel.
        assertThat(treeDrift).isCloseTo(drift, within(theta == 0.3 ? 1e-6 : 5e-4));
        assertThat(tree.conserved().momentumX())
                .isCloseTo(0, within(1e-13 * tree.conserved().momentumScale()));
    }

    private static WorldSpec.Builder gravity() {
        return WorldSpec.builder().gravity(1);
    }

    /** A round cloud of total mass 1 and radius 1 that begins to fall together. */
    private static World cluster(WorldSpec spec, int count) {
        var rng = new Rng(9);
        World world = new World(spec);
        while (world.count() < count) {
            double x = rng.between(-1, 1);
            double y = rng.between(-1, 1);
            if (x * x + y * y < 1) {
                world.add(BodyDef.planet(x, y, 1.0 / count, 0));
            }
        }
        return world;
    }
}

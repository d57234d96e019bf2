package io.github.apsis.engine.force;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The gravity solvers against accelerations summed in extended precision (force-*.csv). */
class ReferenceForcesTest {
    @ParameterizedTest
    @CsvSource({"disc-1k, 1e-15", "plummer-1k, 1e-15", "disc-10k, 3e-15", "plummer-10k, 3e-15"})
    void the_direct_sum_is_right_to_rounding(String id, double median) {
        var errors = ForceCase.of(id).errorsOf(new DirectGravity(1, 0));

        assertThat(errors.median()).isLessThan(median);
        assertThat(errors.worst()).isLessThan(1e-13); // where pulls of 1000 or 10 000 bodies nearly cancel
        assertThat(errors.netForce()).isLessThan(1e-15);
    }

    // The bounds are those of a plain quadrupole tree in C at the same angle, which is not the same as ours.
    @ParameterizedTest
    @CsvSource({
        "disc-1k, 0.5, 1.2e-3, 2e-2, 1.5e-4",
        "plummer-1k, 0.5, 1.2e-3, 2e-2, 1.5e-4",
        "disc-10k, 0.5, 1.2e-3, 2e-2, 1.2e-4",
        "plummer-10k, 0.5, 1.2e-3, 2e-2, 1.2e-4",
        "disc-1k, 0.3, 1.5e-4, 2e-3, 1.5e-4",
        "plummer-1k, 0.3, 1.5e-4, 2e-3, 1.5e-4",
        "disc-10k, 0.3, 1.5e-4, 2e-3, 1.2e-4",
        "plummer-10k, 0.3, 1.5e-4, 2e-3, 1.2e-4"
    })
    void the_tree_is_at_least_as_good_as_a_quadrupole_tree(
            String id, double theta, double median, double percentile99, double rms) {
        var errors = ForceCase.of(id).errorsOf(new TreeGravity(1, 0, theta));

        assertThat(errors.median()).isLessThan(median);
        assertThat(errors.percentile99()).isLessThan(percentile99);
        assertThat(errors.rms()).isLessThan(rms);
        assertThat(errors.netForce()).isLessThan(1e-15); // every interaction serves both sides
    }

    @ParameterizedTest
    @ValueSource(strings = {"disc-1k", "plummer-1k"})
    void a_tree_that_opens_every_cell_is_the_direct_sum(String id) {
        var errors = ForceCase.of(id).errorsOf(new TreeGravity(1, 0, 1e-6));

        assertThat(errors.worst()).isLessThan(1e-13);
    }

    @ParameterizedTest
    @ValueSource(strings = {"disc-1k", "plummer-1k"})
    void softened_pulls_are_right_too(String id) {
        var exact = ForceCase.of(id).errorsOfSoftened(new DirectGravity(1, 0.01));
        var tree = ForceCase.of(id).errorsOfSoftened(new TreeGravity(1, 0.01, 0.5));

        assertThat(exact.worst()).isLessThan(1e-13);
        assertThat(tree.median()).isLessThan(1.2e-3);
        assertThat(tree.rms()).isLessThan(1.5e-4);
    }
}

package io.github.apsis.engine.integration;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.ReferenceCase;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.WorldSpec.Integration;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Ten thousand periods of the figure-eight: a symplectic method keeps its energy, and rounding alone moves the exact ones. */
class LongRunTest {
    private static final double PERIOD = 6.32591398;

    @ParameterizedTest
    @CsvSource({
        "VELOCITY_VERLET, 150, 4e-5",
        "YOSHIDA4, 150, 2.1e-9",
        "PEFRL, 150, 5e-10",
    })
    void a_symplectic_method_does_not_drift(Integration method, int ticksPerUnit, double bound) {
        World world = figureEight(method, 1.0 / ticksPerUnit);

        double first = worstEnergyError(world, 10 * PERIOD);
        double last = worstEnergyError(world, 10_000 * PERIOD);

        assertThat(last).isLessThan(bound);
        assertThat(Math.max(first, last) / first).isLessThan(1.2);
    }

    @ParameterizedTest
    @CsvSource({"SYMPLECTIC8, 0.0266666666666666667, 5e-14", "ADAPTIVE, 1, 2e-14"})
    void rounding_walks_no_faster_than_the_root_of_time(Integration method, double dt, double bound) {
        World world = figureEight(method, dt);

        double first = worstEnergyError(world, 100 * PERIOD);
        double last = worstEnergyError(world, 10_000 * PERIOD);

        assertThat(last).isLessThan(bound);
        // Ten times the root of time, and as much again for a walk that has begun with a lucky hundred periods.
        assertThat(last / Math.max(first, 1e-15)).isLessThan(20);
    }

    private static World figureEight(Integration method, double dt) {
        return ReferenceCase.of("figure8")
                .world(WorldSpec.builder().gravity(1).integration(method).dt(dt).build());
    }

    /** Relative, over 1000 moments from now on. */
    private static double worstEnergyError(World world, double until) {
        double energy = ReferenceCase.of("figure8").node("conserved").get("E").asDouble();
        double worst = 0;
        double from = world.time();
        for (int moment = 1; moment <= 1000; moment++) {
            while (world.time() < from + (until - from) * moment / 1000) {
                world.step();
            }
            worst = Math.max(worst, Math.abs(world.conserved().energy().orElseThrow() / energy - 1));
        }
        return worst;
    }
}

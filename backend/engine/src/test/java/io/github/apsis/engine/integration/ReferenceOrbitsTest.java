package io.github.apsis.engine.integration;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.ReferenceCase;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.WorldSpec.Integration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.databind.JsonNode;

/**
 * Orbits against their true states. The tolerances are 1.5 times what a plain C program in double gives with the same method:
 * meeting them shows that the named method runs, and nothing else.
 */
class ReferenceOrbitsTest {
    @ParameterizedTest(name = "{0} by {1} until {2}")
    @MethodSource("tolerances")
    void an_orbit_stays_within_the_tolerance_of_its_method(
            String id, Integration method, double until, JsonNode tolerance) {
        ReferenceCase orbit = ReferenceCase.of(id);
        World world = orbit.world(WorldSpec.builder()
                .gravity(orbit.number("G"))
                .integration(method)
                .build());
        double energy0 = orbit.node("conserved").get("E").asDouble();
        double spin0 = orbit.node("conserved").get("L").asDouble();
        double energyError = 0;
        double spinError = 0;

        for (ReferenceCase.Sample sample : orbit.samples()) {
            if (sample.time() > until) {
                break;
            }
            while (world.tick() < sample.tick()) {
                world.step();
                var now = world.conserved();
                energyError = Math.max(energyError, Math.abs(now.energy().orElseThrow() - energy0));
                spinError = Math.max(spinError, Math.abs(now.angularMomentum() - spin0));
            }
            if (sample.time() == until) {
                assertThat(sample.positionError(world.snapshot()) / orbit.number("length_scale"))
                        .as("position")
                        .isLessThanOrEqualTo(tolerance.get("position").asDouble());
            }
        }

        assertThat(energyError / orbit.number("energy_scale"))
                .as("energy")
                .isLessThanOrEqualTo(tolerance.get("energy").asDouble());
        assertThat(spinError / orbit.number("L_scale"))
                .as("angular momentum")
                .isLessThanOrEqualTo(tolerance.get("L").asDouble());
    }

    static List<Arguments> tolerances() {
        List<Arguments> rows = new ArrayList<>();
        JsonNode cases = ReferenceCase.of("tolerances").node("cases");
        for (String id :
                List.of("kepler-e00-equal", "kepler-e05-equal", "kepler-e05-test", "kepler-e09-equal", "figure8")) {
            for (JsonNode row : cases.get(id)) {
                String method = row.get("method").asString();
                boolean known = method.equals("leapfrog") || method.equals("semi-implicit-euler");
                if (known && row.get("position") != null && !row.get("position").isNull()) {
                    Integration integration =
                            method.equals("leapfrog") ? Integration.VELOCITY_VERLET : Integration.SEMI_IMPLICIT_EULER;
                    rows.add(Arguments.of(id, integration, row.get("T").asDouble(), row));
                }
            }
        }
        return rows;
    }
}

package io.github.apsis.engine.integration;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.ReferenceCase;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.WorldSpec.Integration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.databind.JsonNode;

/**
 * Orbits against their true states. For a fixed step the tolerances are 1.5 times what a plain C program in double gives with
 * the same method: meeting them shows that the named method runs, and nothing else. For the adaptive method they are 3 times
 * what REBOUND's IAS15 reaches.
 */
class ReferenceOrbitsTest {
    private static final Map<String, Integration> METHODS = Map.of(
            "semi-implicit-euler", Integration.SEMI_IMPLICIT_EULER,
            "leapfrog", Integration.VELOCITY_VERLET,
            "yoshida4", Integration.YOSHIDA4,
            "adaptive", Integration.ADAPTIVE);

    @ParameterizedTest(name = "{0} by {1} at ticks of {2}")
    @MethodSource("tolerances")
    void an_orbit_stays_within_the_tolerances_of_its_method(
            String id, Integration method, double dt, List<JsonNode> tolerances) {
        ReferenceCase orbit = ReferenceCase.of(id);
        World world = orbit.world(WorldSpec.builder()
                .gravity(orbit.number("G"))
                .integration(method)
                .dt(dt)
                .build());
        double energy0 = orbit.node("conserved").get("E").asDouble();
        double spin0 = orbit.node("conserved").get("L").asDouble();
        double energyError = 0;
        double spinError = 0;

        for (JsonNode tolerance : tolerances) {
            ReferenceCase.Sample sample = sampleAt(orbit, tolerance.get("T").asDouble());
            while (world.tick() < sample.tick(dt)) {
                world.step();
                if (isWhole(world.time())) {
                    var now = world.conserved();
                    energyError = Math.max(energyError, Math.abs(now.energy().orElseThrow() - energy0));
                    spinError = Math.max(spinError, Math.abs(now.angularMomentum() - spin0));
                }
            }
            if (!tolerance.path("position").isNumber()) {
                continue; // the method cannot follow this case at this step: it need only stay finite, which the world
                // sees to
            }
            String moment = " at " + sample.time();
            assertThat(sample.positionError(world.snapshot()) / orbit.number("length_scale"))
                    .as("position" + moment)
                    .isLessThanOrEqualTo(tolerance.get("position").asDouble());
            assertThat(energyError / orbit.number("energy_scale"))
                    .as("energy" + moment)
                    .isLessThanOrEqualTo(tolerance.get("energy").asDouble());
            assertThat(spinError / orbit.number("L_scale"))
                    .as("angular momentum" + moment)
                    .isLessThanOrEqualTo(tolerance.get("L").asDouble());
        }
    }

    /** The tolerances were measured at whole times; within an orbit a symplectic method's energy swings further. */
    private static boolean isWhole(double time) {
        return Math.abs(time - Math.rint(time)) < 1e-9 * Math.max(1, time);
    }

    private static ReferenceCase.Sample sampleAt(ReferenceCase orbit, double time) {
        return orbit.samples().stream()
                .filter(sample -> sample.time() == time)
                .findFirst()
                .orElseThrow();
    }

    /** A fraction like 1/150; any tick will do for the adaptive method, and all samples are at whole times. */
    private static double tickOf(JsonNode row) {
        if (row.get("dt").isNull()) {
            return 1;
        }
        String[] fraction = row.get("dt").asString().split("/", -1);
        return Double.parseDouble(fraction[0]) / Double.parseDouble(fraction[1]);
    }

    static List<Arguments> tolerances() {
        List<Arguments> rows = new ArrayList<>();
        JsonNode cases = ReferenceCase.of("tolerances").node("cases");
        for (String id : cases.propertyNames()) {
            METHODS.forEach((name, method) -> {
                List<JsonNode> ofMethod = new ArrayList<>();
                cases.get(id).forEach(row -> {
                    if (row.get("method").asString().equals(name)) {
                        ofMethod.add(row);
                    }
                });
                rows.add(Arguments.of(id, method, tickOf(ofMethod.get(0)), ofMethod));
            });
        }
        return rows;
    }
}

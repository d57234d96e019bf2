package io.github.apsis.benchmarks.steering;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.benchmarks.reference.Json;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;

class SteeringScenesTest {
    @ParameterizedTest
    @ValueSource(
            strings = {"headon", "streams", "circle50", "circle200", "field", "planet", "wander", "arrival", "belt"})
    void every_public_instance_is_what_two_other_builders_make_of_it(String name)
            throws IOException, URISyntaxException {
        var file = Objects.requireNonNull(getClass().getResource("/steering/checksums.json"));
        JsonNode sums = Json.field(Json.read(Path.of(file.toURI())), name);
        int first = name.equals("headon") || name.equals("arrival") ? 0 : 1;

        assertThat(sums.size()).isGreaterThanOrEqualTo(5);
        for (int k = 0; k < sums.size(); k++) {
            assertThat(SteeringScenes.of(name, first + k).checksum())
                    .as("%s %d", name, first + k)
                    .isEqualTo(sums.get(k).asString());
        }
    }

    @Test
    void a_ship_that_flies_straight_through_the_field_meets_six_asteroids() {
        SteeringTally tally = SteeringTally.of(SteeringScenes.of("field", 1), Contender.NO_AVOIDANCE);

        assertThat(tally.arrived).isEqualTo(10);
        assertThat(tally.hitShips).isEqualTo(10);
        assertThat(tally.events / 10.0).isBetween(4.0, 8.0);
        assertThat(tally.timeRatio()).isBetween(1.07, 1.08); // the start and the slowing down take that much
    }

    @Test
    void our_ships_cross_it_without_touching_one() {
        SteeringTally tally = SteeringTally.of(SteeringScenes.of("field", 1), Contender.APSIS);

        assertThat(tally.arrived).isEqualTo(10);
        assertThat(tally.events).isZero();
    }

    @Test
    void gdx_ai_brakes_before_a_meeting_head_on() {
        SteeringTally tally = SteeringTally.of(SteeringScenes.of("headon", 1), Contender.GDX_PRIORITY);

        assertThat(tally.events).isZero();
        assertThat(tally.jerk()).isGreaterThan(20); // as measured elsewhere with the same library
    }

    @Test
    void orca_keeps_two_streams_apart_that_cross() {
        SteeringTally tally = SteeringTally.of(SteeringScenes.of("streams", 1), Contender.ORCA);

        assertThat(tally.arrived).isEqualTo(120);
        assertThat(tally.events).isZero(); // as another implementation
    }
}

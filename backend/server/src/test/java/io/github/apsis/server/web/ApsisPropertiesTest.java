package io.github.apsis.server.web;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ApsisPropertiesTest {
    private static final ApsisProperties.Limits LIMITS = new ApsisProperties.Limits(16384, 2000, 50, 100, 500, 0.8);

    @ParameterizedTest
    @ValueSource(ints = {150, 75, 50, 30, 25, 15, 10, 1})
    void a_frame_rate_divides_150(int rate) {
        assertThat(properties("empty", rate, List.of()).frameRate()).isEqualTo(rate);
    }

    @ParameterizedTest
    @ValueSource(ints = {60, 40, 0, -30, 300})
    void another_frame_rate_is_refused(int rate) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> properties("empty", rate, List.of()))
                .withMessageContaining("apsis.frame-rate must divide 150")
                .withMessageContaining("was " + rate);
    }

    @ParameterizedTest
    @ValueSource(strings = {"*", "https://*.example", "http://localhost:*"})
    void an_origin_is_never_a_pattern(String origin) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> properties("empty", 30, List.of("https://school.example", origin)))
                .withMessageContaining("apsis.allowed-origins");
    }

    @Test
    void an_unknown_scene_is_answered_with_the_known_ones() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> properties("atlantis", 30, List.of()))
                .withMessageContaining("belt-and-swarm")
                .withMessageContaining("was atlantis");
    }

    @Test
    void a_limit_of_nothing_is_refused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new ApsisProperties.Limits(16384, 2000, 50, 100, 0, 0.8))
                .withMessage("apsis.limits.sessions must be 1 or more, was 0");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new ApsisProperties.Limits(16384, 2000, 50, 100, 500, 0))
                .withMessage("apsis.limits.load must be above 0 and finite, was 0.0");
    }

    private static ApsisProperties properties(String scene, int frameRate, List<String> origins) {
        return new ApsisProperties(scene, 1, frameRate, origins, LIMITS);
    }
}

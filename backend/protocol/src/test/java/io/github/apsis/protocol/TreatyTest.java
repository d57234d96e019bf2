package io.github.apsis.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.annotation.JsonInclude.Value;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.DeserializationFeature;
import tools.jackson.databind.json.JsonMapper;

/** Both ends read and write the same examples: this is our half. */
class TreatyTest {
    private static final Path MESSAGES = Path.of("../../docs/protocol/messages");

    private final JsonMapper json = JsonMapper.builder()
            .enable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
            .withConfigOverride(BodyState.class, body -> body.setInclude(Value.ALL_NON_NULL))
            .withConfigOverride(RoomInfo.Edge.class, edge -> edge.setInclude(Value.ALL_NON_NULL))
            .build();

    @ParameterizedTest
    @CsvSource({
        "bodies.json, io.github.apsis.protocol.BodyState[]",
        "delete-body.json, io.github.apsis.protocol.ClientMessage$Delete",
        "diagnostics.json, io.github.apsis.protocol.Diagnostics",
        "events.json, io.github.apsis.protocol.Events",
        "move-selected-spaceships.json, io.github.apsis.protocol.ClientMessage$Move",
        "problem.json, io.github.apsis.protocol.Problem",
        "reply.json, io.github.apsis.protocol.Reply",
        "room.json, io.github.apsis.protocol.RoomInfo",
        "select-body.json, io.github.apsis.protocol.ClientMessage$Select",
        "ship.json, io.github.apsis.protocol.ShipState",
    })
    void a_golden_example_survives_reading_and_writing(String file, String type) throws Exception {
        String golden = Files.readString(MESSAGES.resolve(file));

        Object message = json.readValue(golden, typeNamed(type));

        assertThat(json.readTree(json.writeValueAsString(message))).isEqualTo(json.readTree(golden));
    }

    @Test
    void no_golden_example_is_forgotten() throws IOException {
        try (Stream<Path> files = Files.list(MESSAGES)) {
            Set<String> names = files.map(file -> file.getFileName().toString()).collect(Collectors.toSet());

            assertThat(names)
                    .containsExactlyInAnyOrder(
                            "bodies.json",
                            "delete-body.json",
                            "diagnostics.json",
                            "events.json",
                            "move-selected-spaceships.json",
                            "problem.json",
                            "reply.json",
                            "room.json",
                            "select-body.json",
                            "ship.json");
        }
    }

    @Test
    void the_treaty_names_every_code() throws IOException {
        String treaty = Files.readString(Path.of("../../docs/protocol/PROTOCOL.md"));

        assertThat(Problem.Code.values()).allSatisfy(code -> assertThat(treaty).contains("| `" + code + "` |"));
    }

    private static Class<?> typeNamed(String name) throws ClassNotFoundException {
        return name.endsWith("[]")
                ? Class.forName(name.substring(0, name.length() - 2)).arrayType()
                : Class.forName(name);
    }
}

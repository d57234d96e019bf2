package io.github.apsis.server.web;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.protocol.BodyState;
import io.github.apsis.protocol.ClientMessage;
import io.github.apsis.protocol.Diagnostics;
import io.github.apsis.protocol.Events;
import io.github.apsis.protocol.Frame;
import io.github.apsis.protocol.Problem;
import io.github.apsis.protocol.Reply;
import io.github.apsis.protocol.RoomInfo;
import io.github.apsis.protocol.ShipState;
import io.github.apsis.protocol.json.FrameEncoder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.json.JsonMapper;

/** What the server itself writes and reads, against the golden examples. */
class TreatyTest {
    private final JsonMapper.Builder builder = JsonMapper.builder();
    private final JsonMapper json = treaty();
    private final CommandReader reader = new CommandReader();

    private JsonMapper treaty() {
        new RoomConfig().treaty().customize(builder);
        return builder.build();
    }

    @Test
    void frames_are_written_as_the_treaty_says() throws Exception {
        String golden = Goldens.read("bodies.json");
        FrameEncoder encoder = new FrameEncoder();
        Frame frame = new Frame(1, 1 / 150.0, List.of(json.readValue(golden, BodyState[].class)));

        String first = encoder.encode(frame);
        String second = encoder.encode(frame);

        assertThat(json.readTree(first)).isEqualTo(json.readTree(golden));
        assertThat(second).isEqualTo(first);
    }

    @ParameterizedTest
    @CsvSource({
        "diagnostics.json, Diagnostics",
        "events.json, Events",
        "problem.json, Problem",
        "reply.json, Reply",
        "room.json, RoomInfo",
        "ship.json, ShipState"
    })
    void answers_are_written_as_the_treaty_says(String file, String type) throws Exception {
        String golden = Goldens.read(file);
        Class<?> record = List.of(
                        Diagnostics.class, Events.class, Problem.class, Reply.class, RoomInfo.class, ShipState.class)
                .stream()
                .filter(candidate -> candidate.getSimpleName().equals(type))
                .findFirst()
                .orElseThrow();

        String written = json.writeValueAsString(json.readValue(golden, record));

        assertThat(json.readTree(written)).isEqualTo(json.readTree(golden));
    }

    @Test
    void commands_are_read_as_the_treaty_says() throws Exception {
        assertThat(reader.select(bytes("select-body.json"))).isEqualTo(new ClientMessage.Select(17, true));
        assertThat(reader.delete(bytes("delete-body.json"))).isEqualTo(new ClientMessage.Delete(17));
        assertThat(reader.move(bytes("move-selected-spaceships.json"))).isEqualTo(new ClientMessage.Move(612, 208));
    }

    private static byte[] bytes(String golden) throws Exception {
        return Goldens.read(golden).getBytes(StandardCharsets.UTF_8);
    }
}

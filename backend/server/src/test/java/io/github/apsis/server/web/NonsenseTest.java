package io.github.apsis.server.web;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.protocol.BodyState;
import io.github.apsis.protocol.Problem;
import io.github.apsis.protocol.Problem.Code;
import io.github.apsis.server.room.OpenRoom;
import io.github.apsis.server.room.Rooms;
import io.github.apsis.server.web.RawSocket.Received;
import io.github.apsis.server.web.TestClient.Transport;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.boot.test.context.SpringBootTest;
import org.springframework.boot.test.context.SpringBootTest.WebEnvironment;
import org.springframework.boot.test.web.server.LocalServerPort;

/**
 * Whatever a client sends, it alone is told, the world stays as it is and the tick goes on. A second client watches
 * each case.
 */
@SpringBootTest(webEnvironment = WebEnvironment.RANDOM_PORT)
class NonsenseTest {
    private static final String MOVE = "/app/move-selected-spaceships";

    @LocalServerPort
    private int port;

    @Autowired
    private Rooms rooms;

    private TestClient bystander;
    private TestClient client;
    private Set<Long> idsBefore;
    private long tickBefore;
    private long nanosBefore;
    private long droppedBefore;

    @BeforeEach
    void look() throws Exception {
        bystander = TestClient.connect(port);
        client = TestClient.connect(port);
        idsBefore = ids();
        tickBefore = bystander.frame().tick();
        nanosBefore = System.nanoTime();
        droppedBefore = room().pace().droppedTicks();
    }

    @AfterEach
    void nobody_else_noticed() throws Exception {
        long tick = bystander.frame().tick();
        double seconds = (System.nanoTime() - nanosBefore) / 1e9;
        long dropped = room().pace().droppedTicks() - droppedBefore;
        assertThat(tick - tickBefore + dropped)
                .as("ticks in %.2f s", seconds)
                .isBetween((long) (seconds * 150) - 20, (long) (seconds * 150) + 20);
        assertThat(dropped).as("ticks given up").isLessThan(15); // a busy machine may cost a few, a blocked tick many
        assertThat(rooms.failures()).isZero();
        assertThat(ids()).isEqualTo(idsBefore);
        assertThat(bystander.bodies()).noneMatch(body -> body.selected() || body.target() != null);
        assertThat(bystander.problemsSoFar()).isEmpty();
        assertThat(bystander.repliesSoFar()).isEmpty();
        client.close();
        bystander.close();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"{\"x\":1,\"y\"", "hello", "[1,2]", "17", "null", "\"x\"", "", "{\"x\":1,\"y\":2}{}", "{x:1,y:2}"
            })
    void what_is_not_a_json_object_is_malformed(String body) throws Exception {
        client.send(MOVE, body);

        assertThat(onlyProblem()).isEqualTo(Code.MALFORMED_JSON);
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "/app/move-selected-spaceships | {\"x\":1}                    | y",
                "/app/move-selected-spaceships | {}                           | x",
                "/app/select-body              | {\"selected\":true}          | id",
                "/app/select-body              | {\"id\":1}                   | selected",
                "/app/delete-body              | {\"ID\":1}                   | id",
            })
    void a_missing_field_is_named(String destination, String body, String field) throws Exception {
        client.send(destination, body);

        Problem problem = client.problem();
        assertThat(problem.code()).isEqualTo(Code.MISSING_FIELD);
        assertThat(problem.field()).isEqualTo(field);
        assertThat(problem.message()).contains(field);
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "/app/move-selected-spaceships | {\"x\":NaN,\"y\":0}          | x",
                "/app/move-selected-spaceships | {\"x\":0,\"y\":-Infinity}    | y",
                "/app/move-selected-spaceships | {\"x\":1e400,\"y\":0}        | x",
                "/app/move-selected-spaceships | {\"x\":0,\"y\":-1e400}       | y",
                "/app/move-selected-spaceships | {\"x\":\"12\",\"y\":0}       | x",
                "/app/move-selected-spaceships | {\"x\":null,\"y\":0}         | x",
                "/app/move-selected-spaceships | {\"x\":[1],\"y\":0}          | x",
                "/app/delete-body              | {\"id\":1.5}                 | id",
                "/app/delete-body              | {\"id\":\"1\"}               | id",
                "/app/delete-body              | {\"id\":-1}                  | id",
                "/app/delete-body              | {\"id\":0}                   | id",
                "/app/delete-body              | {\"id\":99999999999999999999} | id",
                "/app/delete-body              | {\"id\":true}                | id",
                "/app/select-body              | {\"id\":1,\"selected\":1}    | selected",
                "/app/select-body              | {\"id\":1,\"selected\":null} | selected",
            })
    void a_value_of_the_wrong_kind_is_named(String destination, String body, String field) throws Exception {
        client.send(destination, body);

        Problem problem = client.problem();
        assertThat(problem.code()).isEqualTo(Code.INVALID_VALUE);
        assertThat(problem.field()).isEqualTo(field);
        assertThat(problem.message()).contains("\"" + field + "\" must be").doesNotContain("Exception");
    }

    @ParameterizedTest
    @CsvSource(
            quoteCharacter = '`',
            delimiter = '|',
            value = {
                "/app/delete-body | {\"id\":9007199254740993}",
                "/app/select-body | {\"id\":987654321,\"selected\":true}",
                "/app/select-body | {\"id\":987654321,\"selected\":false}",
            })
    void an_unknown_id_is_refused(String destination, String body) throws Exception {
        client.send(destination, body);

        assertThat(onlyProblem()).isEqualTo(Code.NO_SUCH_BODY);
    }

    @Test
    void a_deleted_body_cannot_be_selected() throws Exception {
        client.send("/app/random-asteroid");
        long id = client.reply().ids().get(0);
        client.send("/app/delete-body", "{\"id\":" + id + "}");
        client.reply();

        client.send("/app/select-body", "{\"id\":" + id + ",\"selected\":true}");

        assertThat(onlyProblem()).isEqualTo(Code.NO_SUCH_BODY);
    }

    @Test
    void a_target_outside_the_world_is_refused() throws Exception {
        long ship = aShip();
        client.send("/app/select-body", "{\"id\":" + ship + ",\"selected\":true}");
        client.reply();

        client.send(MOVE, "{\"x\":5000,\"y\":0}");

        Problem problem = client.problem();
        assertThat(problem.code()).isEqualTo(Code.OUTSIDE_WORLD);
        assertThat(problem.field()).isEqualTo("x");
        assertThat(problem.message())
                .isEqualTo(
                        "The target (5000, 0) lies outside the world. Choose a point inside x -1000 to 1000, y -1000 to 1000.");
        assertThat(client.body(ship).orElseThrow().target()).isNull();
        client.send("/app/select-body", "{\"id\":" + ship + ",\"selected\":false}");
        client.await(ship, body -> !body.selected());
    }

    @Test
    void a_move_without_a_selected_ship_is_refused() throws Exception {
        client.send(MOVE, "{\"x\":0,\"y\":0}");

        assertThat(onlyProblem()).isEqualTo(Code.NO_SHIP_SELECTED);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "/app/nonsense",
                "/topic/bodies",
                "/topic/diagnostics",
                "/queue/errors",
                "/user/queue/errors",
                "/app/random-planet/",
                "/app/../app/random-planet",
                "/app/random-%70lanet",
                "/app/room",
                "/app/**",
                "nowhere"
            })
    void a_send_to_anything_else_is_refused(String destination) throws Exception {
        client.send(destination, "[]");

        assertThat(onlyProblem()).isEqualTo(Code.UNKNOWN_DESTINATION);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "/topic/**",
                "/topic/*",
                "/**",
                "/topic/bodies/1",
                "/queue/errors",
                "/queue/**",
                "/user/**",
                "/user/queue/*",
                "/user/someone/queue/errors",
                "/app/random-planet",
                "/topic/b?dies"
            })
    void a_subscription_to_anything_else_is_refused(String destination) throws Exception {
        client.hear(destination, heard -> {
            throw new AssertionError("heard " + heard);
        });

        assertThat(onlyProblem()).isEqualTo(Code.UNKNOWN_DESTINATION);
    }

    @Test
    void a_thousand_commands_in_a_second_are_mostly_refused_and_some_of_that_is_told() throws Exception {
        for (int i = 0; i < 1000; i++) {
            client.send("/app/select-body", "{\"id\":987654321,\"selected\":true}");
        }
        client.frame();
        Thread.sleep(300); // let the last answers arrive

        List<Problem> problems = client.problemsSoFar();
        assertThat(problems.stream()
                        .filter(problem -> problem.code() == Code.NO_SUCH_BODY)
                        .count())
                .as("commands that got through")
                .isBetween(90L, 400L);
        assertThat(problems.stream()
                        .filter(problem -> problem.code() == Code.TOO_MANY_COMMANDS)
                        .count())
                .as("complaints")
                .isBetween(1L, 80L);
    }

    @ParameterizedTest
    @EnumSource(value = Transport.class)
    void a_message_of_two_megabytes_ends_its_session_with_a_reason(Transport transport) throws Exception {
        String huge = "SEND\ndestination:" + MOVE + "\n\n" + "x".repeat(2_000_000) + "\0";
        Received error =
                switch (transport) {
                    case NATIVE -> sendRaw(Destinations.ENDPOINT, huge, false);
                    case SOCKJS_WEBSOCKET -> sendRaw(Destinations.ENDPOINT + "/000/abcdefgh/websocket", huge, true);
                    case SOCKJS_XHR -> new Received(SockJsByHand.sendHuge(port, huge), 0);
                };

        assertThat(error.text()).contains("ERROR").contains("MESSAGE_TOO_LARGE").contains("16384");
    }

    @Test
    void a_frame_cut_into_many_messages_may_not_be_larger_either() throws Exception {
        try (RawSocket socket = stompSocket()) {
            socket.send("SEND\ndestination:" + MOVE + "\ncontent-length:9000000\n\n");
            for (int i = 0; i < 20; i++) {
                socket.send("x".repeat(1000));
            }

            assertThat(socket.receive().text()).contains("ERROR").contains("MESSAGE_TOO_LARGE");
            assertThat(socket.receive().isClose()).isTrue();
        }
    }

    @Test
    void a_message_just_within_the_limit_passes() throws Exception {
        client.send(MOVE, " ".repeat(15_000) + "{\"x\":0,\"y\":0}");

        assertThat(onlyProblem()).isEqualTo(Code.NO_SHIP_SELECTED);
    }

    @ParameterizedTest
    @ValueSource(strings = {"HELLO\n\n\0", "<html>\n\n\0", "SEND\nno-colon\n\n\0", "GET / HTTP/1.1\nHost: x\n\n\0"})
    void what_is_not_stomp_ends_its_session_with_a_reason(String frame) throws Exception {
        try (RawSocket socket = stompSocket()) {
            socket.send(frame);

            Received error = socket.receive();
            assertThat(error.text()).startsWith("ERROR\n").contains("MALFORMED_FRAME");
            assertThat(error.text()).doesNotContain("springframework").doesNotContain("Exception");
            assertThat(socket.receive().isClose()).isTrue();
        }
    }

    @Test
    void nothing_goes_before_connect() throws Exception {
        try (RawSocket socket = new RawSocket(port, Destinations.ENDPOINT)) {
            socket.send("SEND\ndestination:/app/random-planet\n\n\0");

            assertThat(socket.receive().text()).startsWith("ERROR\n").contains("MALFORMED_FRAME");
        }
    }

    private Received sendRaw(String path, String stomp, boolean sockJs) throws Exception {
        try (RawSocket socket = new RawSocket(port, path)) {
            if (sockJs) {
                assertThat(socket.receive().text()).isEqualTo("o");
                socket.send("[\"CONNECT\\naccept-version:1.2\\n\\n\\u0000\"]");
                assertThat(socket.receive().text()).contains("CONNECTED");
                socket.send("[\"" + stomp.replace("\n", "\\n").replace("\0", "\\u0000") + "\"]");
            } else {
                socket.connectStomp();
                assertThat(socket.receive().text()).startsWith("CONNECTED");
                socket.send(stomp);
            }
            Received error = socket.receive();
            Received end = socket.receive();
            assertThat(sockJs && end.text().startsWith("c[1009") || end.closeStatus() == 1009)
                    .as("closed with 1009, was " + end)
                    .isTrue();
            return error;
        }
    }

    private RawSocket stompSocket() throws Exception {
        RawSocket socket = new RawSocket(port, Destinations.ENDPOINT);
        socket.connectStomp();
        assertThat(socket.receive().text()).startsWith("CONNECTED");
        return socket;
    }

    private Code onlyProblem() throws InterruptedException {
        Problem problem = client.problem();
        assertThat(problem.message()).isNotBlank().doesNotContain("Exception");
        assertThat(client.repliesSoFar()).isEmpty();
        return problem.code();
    }

    private OpenRoom room() {
        return rooms.byId(CommandDesk.PUBLIC_ROOM).orElseThrow();
    }

    private long aShip() throws InterruptedException {
        return client.bodies().stream()
                .filter(body -> body.thrust() != null)
                .findFirst()
                .orElseThrow()
                .id();
    }

    private Set<Long> ids() throws InterruptedException {
        Set<Long> ids = new HashSet<>();
        for (BodyState body : bystander.bodies()) {
            ids.add(body.id());
        }
        return ids;
    }
}

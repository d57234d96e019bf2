package io.github.apsis.server.web;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.protocol.BodyState;
import io.github.apsis.protocol.Diagnostics;
import io.github.apsis.protocol.Events;
import io.github.apsis.protocol.Kind;
import io.github.apsis.protocol.Point;
import io.github.apsis.protocol.Reply;
import io.github.apsis.protocol.RoomInfo;
import io.github.apsis.protocol.ShipState;
import io.github.apsis.server.web.TestClient.Heard;
import io.github.apsis.server.web.TestClient.Transport;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.boot.test.context.SpringBootTest;
import org.springframework.boot.test.context.SpringBootTest.WebEnvironment;
import org.springframework.boot.test.web.server.LocalServerPort;
import tools.jackson.databind.json.JsonMapper;

/** The default scene as it is shipped, steered by real clients. */
@SpringBootTest(webEnvironment = WebEnvironment.RANDOM_PORT)
class WireTest {
    @LocalServerPort
    private int port;

    @Autowired
    private JsonMapper json;

    @ParameterizedTest
    @EnumSource
    void a_client_adds_selects_and_removes_bodies(Transport transport) throws Exception {
        try (TestClient client = TestClient.connect(transport, port)) {
            client.send("/app/random-spaceship");
            Reply added = client.reply();
            long ship = added.ids().get(0);
            assertThat(added.command()).isEqualTo("random-spaceship");
            assertThat(client.await(ship, body -> true).kind()).isEqualTo(Kind.SHIP);

            client.send("/app/select-body", "{\"id\":" + ship + ",\"selected\":true}");
            assertThat(client.reply().ids()).containsExactly(ship);
            client.await(ship, BodyState::selected);

            client.send("/app/select-body", "{\"id\":" + ship + ",\"selected\":false}");
            client.await(ship, body -> !body.selected());

            client.send("/app/delete-body", "{\"id\":" + ship + "}");
            client.awaitBodies(bodies -> bodies.stream().noneMatch(body -> body.id() == ship));
        }
    }

    @ParameterizedTest
    @CsvSource({"random-planet, PLANET", "random-asteroid, ASTEROID", "random-spaceship, SHIP", "random-body,"})
    void each_kind_of_body_can_be_added(String command, Kind kind) throws Exception {
        try (TestClient client = TestClient.connect(port)) {
            client.send("/app/" + command);

            Reply added = client.reply();
            BodyState body = client.await(added.ids().get(0), any -> true);

            assertThat(added.command()).isEqualTo(command);
            assertThat(body.kind()).isEqualTo(kind == null ? body.kind() : kind);
            assertThat(body.vertices() != null).isEqualTo(body.kind() == Kind.ASTEROID);
            assertThat(body.angle() != null).isEqualTo(body.kind() == Kind.ASTEROID);
            assertThat(body.thrust() != null).isEqualTo(body.kind() == Kind.SHIP);
            assertThat(body.target()).isNull();
            client.send("/app/delete-body", "{\"id\":" + body.id() + "}");
        }
    }

    @Test
    void a_selected_ship_flies_to_the_point_and_stops_there() throws Exception {
        try (TestClient client = TestClient.connect(port)) {
            client.send("/app/random-spaceship");
            long ship = client.reply().ids().get(0);
            client.send("/app/select-body", "{\"id\":" + ship + ",\"selected\":true}");
            client.reply();
            double x = 850; // a corner where nothing orbits
            double y = 850;

            client.send("/app/move-selected-spaceships", "{\"x\":" + x + ",\"y\":" + y + "}");

            assertThat(client.reply().ids()).containsExactly(ship);
            BodyState ordered = client.await(ship, body -> body.target() != null);
            assertThat(ordered.target()).isEqualTo(new Point(x, y));
            client.await(
                    ship,
                    body -> Math.hypot(body.position().x() - x, body.position().y() - y) < 1
                            && Math.hypot(body.velocity().x(), body.velocity().y()) < 1);
            client.send("/app/delete-body", "{\"id\":" + ship + "}");
        }
    }

    @Test
    void a_selection_ends_with_its_session() throws Exception {
        try (TestClient watcher = TestClient.connect(port)) {
            long body = watcher.bodies().get(0).id();
            try (TestClient client = TestClient.connect(port)) {
                client.send("/app/select-body", "{\"id\":" + body + ",\"selected\":true}");
                watcher.await(body, BodyState::selected);
            }

            watcher.await(body, state -> !state.selected());
        }
    }

    @Test
    void frames_carry_tick_time_and_the_moment_of_sending() throws Exception {
        try (TestClient client = TestClient.connect(port)) {
            Heard first = client.frame();
            Heard second = client.frame();

            assertThat(second.tick()).isGreaterThan(first.tick());
            assertThat(second.tick() % 5).isZero(); // 30 of 150
            assertThat(Double.parseDouble(second.headers().getFirst("time"))).isEqualTo(second.tick() / 150.0);
            assertThat(Long.parseLong(second.headers().getFirst("sent")))
                    .isBetween(System.currentTimeMillis() - 5000, System.currentTimeMillis());
            assertThat(second.headers().getContentType()).hasToString("application/json");
            assertThat(second.headers().getContentLength())
                    .isEqualTo(second.body().length());
        }
    }

    @Test
    void thirty_frames_come_in_a_second() throws Exception {
        BlockingQueue<Heard> frames = new LinkedBlockingQueue<>();
        try (TestClient client = TestClient.connect(port)) {
            client.hear("/topic/bodies", frames::add);
            long first =
                    frames.poll(TestClient.PATIENCE_SECONDS, TimeUnit.SECONDS).tick();
            long last = first;
            int count = 0;
            while (last < first + 450) {
                last = frames.poll(TestClient.PATIENCE_SECONDS, TimeUnit.SECONDS)
                        .tick();
                count++;
            }

            assertThat(count).isBetween(70, 90); // three seconds; a busy machine may conflate a few
        }
    }

    @Test
    void diagnostics_say_how_the_room_is_doing() throws Exception {
        try (TestClient client = TestClient.connect(port)) {
            client.diagnostics();

            Diagnostics diagnostics = json.readValue(client.diagnostics().body(), Diagnostics.class);

            assertThat(diagnostics.bodies()).isEqualTo(client.bodies().size());
            assertThat(diagnostics.clients()).isPositive();
            assertThat(diagnostics.time()).isEqualTo(diagnostics.tick() / 150.0);
            assertThat(diagnostics.tickMillis().p50()).isPositive();
            assertThat(diagnostics.energy()).isNotNull().isFinite();
            assertThat(diagnostics.energyDrift()).isNotNull().isFinite();
            assertThat(diagnostics.momentum()).isNotNull();
            assertThat(diagnostics.kinetic()).isNotNull().isPositive();
            assertThat(diagnostics.potential()).isNotNull().isNegative();
            assertThat(diagnostics.angularMomentum()).isNotNull();
            assertThat(diagnostics.angularMomentumDrift()).isNotNull().isFinite();
            assertThat(diagnostics.centreOfMassX()).isNotNull();
            assertThat(diagnostics.virialRatio()).isNotNull().isPositive();
            assertThat(diagnostics.gravitySolver()).isEqualTo("direct");
            assertThat(diagnostics.forceError()).isNull(); // a direct sum has none to sample
        }
    }

    @ParameterizedTest
    @EnumSource
    void a_client_hears_what_its_selected_ship_is_doing(Transport transport) throws Exception {
        BlockingQueue<Heard> ships = new LinkedBlockingQueue<>();
        BlockingQueue<Heard> others = new LinkedBlockingQueue<>();
        try (TestClient client = TestClient.connect(transport, port);
                TestClient bystander = TestClient.connect(port)) {
            client.hear("/user/queue/ship", ships::add);
            bystander.hear("/user/queue/ship", others::add);
            client.send("/app/random-spaceship");
            long ship = client.reply().ids().get(0);
            client.send("/app/select-body", "{\"id\":" + ship + ",\"selected\":true}");
            ShipState wandering = next(ships, state -> true);
            assertThat(wandering.id()).isEqualTo(ship);
            assertThat(wandering.target()).isNull();

            client.reply();
            client.send("/app/move-selected-spaceships", "{\"x\":700,\"y\":700}");
            ShipState seeking = next(ships, state -> state.target() != null);

            assertThat(seeking.target()).isEqualTo(new Point(700, 700));
            assertThat(seeking.tick()).isGreaterThan(wandering.tick());
            assertThat(others).isEmpty();
            client.send("/app/delete-body", "{\"id\":" + ship + "}");
        }
    }

    @ParameterizedTest
    @EnumSource
    void an_arrival_reaches_every_client(Transport transport) throws Exception {
        BlockingQueue<Heard> heard = new LinkedBlockingQueue<>();
        try (TestClient client = TestClient.connect(port);
                TestClient bystander = TestClient.connect(transport, port)) {
            bystander.hear("/topic/events", heard::add);
            client.send("/app/random-spaceship");
            long ship = client.reply().ids().get(0);
            client.send("/app/select-body", "{\"id\":" + ship + ",\"selected\":true}");
            client.reply();
            client.send("/app/move-selected-spaceships", "{\"x\":800,\"y\":-800}"); // a corner without rocks

            assertThat(arrival(heard, ship).other()).isNull();
            client.send("/app/delete-body", "{\"id\":" + ship + "}");
        }
    }

    private Events.Event arrival(BlockingQueue<Heard> heard, long ship) throws Exception {
        while (true) {
            Heard message = heard.poll(3 * TestClient.PATIENCE_SECONDS, TimeUnit.SECONDS);
            assertThat(message).as("the ship has 20 s to go").isNotNull();
            for (Events.Event event :
                    json.readValue(message.body(), Events.class).events()) {
                if (event.ship() == ship && event.type() == Events.Type.ARRIVED) {
                    return event;
                }
            }
        }
    }

    private ShipState next(BlockingQueue<Heard> ships, Predicate<ShipState> wanted) throws Exception {
        while (true) {
            Heard heard = ships.poll(TestClient.PATIENCE_SECONDS, TimeUnit.SECONDS);
            assertThat(heard).isNotNull();
            ShipState state = json.readValue(heard.body(), ShipState.class);
            if (wanted.test(state)) {
                return state;
            }
        }
    }

    @Test
    void the_room_introduces_itself() throws Exception {
        BlockingQueue<Heard> rooms = new LinkedBlockingQueue<>();
        try (TestClient client = TestClient.connect(port)) {
            client.hear("/app/room", rooms::add);
            String text =
                    rooms.poll(TestClient.PATIENCE_SECONDS, TimeUnit.SECONDS).body();
            RoomInfo room = json.readValue(text, RoomInfo.class);

            assertThat(room.room()).isEqualTo("public");
            assertThat(room.scene()).isEqualTo("belt-and-swarm");
            assertThat(room.boundary().kind()).isEqualTo("walls");
            assertThat(List.of(room.tickRate(), room.frameRate(), room.maxBodies()))
                    .containsExactly(150, 30, 2000);
            assertThat(json.readTree(text).propertyNames())
                    .containsExactlyElementsOf(
                            json.readTree(Goldens.read("room.json")).propertyNames());
        }
    }
}

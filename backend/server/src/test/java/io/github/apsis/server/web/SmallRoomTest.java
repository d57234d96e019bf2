package io.github.apsis.server.web;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.protocol.BodyState;
import io.github.apsis.protocol.Problem;
import io.github.apsis.protocol.Problem.Code;
import io.github.apsis.scenes.Measures;
import io.github.apsis.scenes.Palette;
import io.github.apsis.scenes.Palette.Range;
import io.github.apsis.scenes.Scene;
import io.github.apsis.scenes.SceneBody;
import io.github.apsis.scenes.Units;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.springframework.boot.test.context.SpringBootTest;
import org.springframework.boot.test.context.SpringBootTest.WebEnvironment;
import org.springframework.boot.test.context.TestConfiguration;
import org.springframework.boot.test.web.server.LocalServerPort;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Primary;

/** A room that holds three bodies and a place for one planet, on a server for three clients. */
@SpringBootTest(
        webEnvironment = WebEnvironment.RANDOM_PORT,
        properties = {"apsis.limits.bodies=3", "apsis.limits.sessions=3"})
class SmallRoomTest {
    @LocalServerPort
    private int port;

    private TestClient client;
    private TestClient bystander;

    @BeforeEach
    void connect() throws Exception {
        client = TestClient.connect(port);
        bystander = TestClient.connect(port);
    }

    @AfterEach
    void empty_the_room() throws Exception {
        assertThat(bystander.problemsSoFar()).isEmpty();
        for (BodyState body : client.bodies()) {
            client.send("/app/delete-body", "{\"id\":" + body.id() + "}");
        }
        client.awaitBodies(List::isEmpty);
        client.close();
        bystander.close();
    }

    @Test
    void body_number_four_is_refused() throws Exception {
        for (int i = 0; i < 3; i++) {
            client.send("/app/random-spaceship");
            client.reply();
        }

        client.send("/app/random-spaceship");

        Problem problem = client.problem();
        assertThat(problem.code()).isEqualTo(Code.WORLD_FULL);
        assertThat(problem.message()).contains("3 bodies");
        assertThat(bystander.bodies()).hasSize(3);
    }

    @Test
    void where_no_place_is_left_a_planet_is_refused() throws Exception {
        client.send("/app/random-planet");
        client.reply();

        client.send("/app/random-planet");

        assertThat(client.problem().code()).isEqualTo(Code.NO_ROOM);
        assertThat(bystander.bodies()).hasSize(1);
    }

    @Test
    void client_number_four_is_turned_away() throws Exception {
        try (TestClient third = TestClient.connect(port);
                RawSocket fourth = new RawSocket(port, Destinations.ENDPOINT)) {
            assertThat(fourth.status()).isEqualTo(503);
            assertThat(third.bodies()).isEmpty();
        }
    }

    @TestConfiguration
    static class SmallScene {
        @Bean
        @Primary
        Scene smallScene() {
            return new Small();
        }
    }

    private static final class Small implements Scene {
        @Override
        public String name() {
            return "small";
        }

        @Override
        public String title() {
            return "Small";
        }

        @Override
        public Units units() {
            return new Units("u", "kg", "s");
        }

        @Override
        public Aabb view() {
            return Aabb.centred(100, 100);
        }

        @Override
        public Measures measures() {
            return Measures.NONE;
        }

        @Override
        public WorldSpec spec(long seed) {
            return WorldSpec.builder().walls(Aabb.centred(100, 100), 1).build();
        }

        @Override
        public List<SceneBody> bodies(long seed) {
            return List.of();
        }

        @Override
        public Palette palette() {
            return new Palette(
                    Aabb.centred(100, 100),
                    new Range(80, 80),
                    new Range(1, 1),
                    new Range(2, 3),
                    1,
                    1,
                    1,
                    2,
                    5,
                    new ShipLimits(10, 100));
        }
    }
}

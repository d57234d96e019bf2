package io.github.apsis.server.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.springframework.boot.test.context.SpringBootTest;
import org.springframework.boot.test.context.SpringBootTest.WebEnvironment;
import org.springframework.boot.test.web.server.LocalServerPort;

/** What an operator reads. */
@SpringBootTest(webEnvironment = WebEnvironment.RANDOM_PORT)
class MetricsTest {
    @LocalServerPort
    private int port;

    @ParameterizedTest
    @ValueSource(
            strings = {
                "apsis_tick_rate",
                "apsis_clock_speed",
                "apsis_bodies",
                "apsis_ship_collisions_total",
                "apsis_ship_minutes_total",
                "apsis_ship_collisions_per_minute"
            })
    void a_metric_of_the_guide_is_there_for_the_public_room(String metric) throws Exception {
        assertThat(value(metric)).isNotNegative();
    }

    @Test
    void forty_ships_fly_forty_minutes_a_minute() throws Exception {
        try (TestClient client = TestClient.connect(port)) {
            double before = value("apsis_ship_minutes_total");
            long from = client.frame().tick();
            while (client.frame().tick() < from + 300) {
                // two seconds of the room
            }
            // The two are read at different moments of a room that runs: one part in five.
            assertThat(value("apsis_ship_minutes_total") - before).isBetween(0.8 * 40 * 2 / 60, 1.4 * 40 * 2 / 60);
        }
    }

    private double value(String metric) throws Exception {
        String all = HttpClient.newHttpClient()
                .send(
                        HttpRequest.newBuilder(URI.create("http://localhost:" + port + "/actuator/prometheus"))
                                .build(),
                        BodyHandlers.ofString())
                .body();
        Matcher line =
                Pattern.compile("(?m)^" + metric + "\\{room=\"public\"} (.*)$").matcher(all);
        assertThat(line.find()).as(metric + " in " + all).isTrue();
        return Double.parseDouble(line.group(1));
    }
}

package io.github.apsis.server.web;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.springframework.boot.test.context.SpringBootTest;
import org.springframework.boot.test.context.SpringBootTest.WebEnvironment;
import org.springframework.boot.test.web.server.LocalServerPort;

/** Who gets in, and what is agreed on. */
@SpringBootTest(webEnvironment = WebEnvironment.RANDOM_PORT)
class HandshakeTest {
    private static final String SOCKJS = Destinations.ENDPOINT + "/000/handshake/websocket";

    @LocalServerPort
    private int port;

    @ParameterizedTest
    @ValueSource(strings = {Destinations.ENDPOINT, SOCKJS, Destinations.ENDPOINT + "/info"})
    void a_page_of_another_origin_is_turned_away(String path) throws Exception {
        try (RawSocket socket = new RawSocket(port, path, "Origin: http://evil.example")) {
            assertThat(socket.status()).isEqualTo(403);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {Destinations.ENDPOINT, SOCKJS})
    void our_own_page_comes_in(String path) throws Exception {
        try (RawSocket socket = new RawSocket(port, path, "Origin: http://localhost:" + port)) {
            assertThat(socket.status()).isEqualTo(101);
        }
    }

    @Test
    void compression_is_not_agreed_on() throws Exception {
        try (RawSocket socket = new RawSocket(
                port, Destinations.ENDPOINT, "Sec-WebSocket-Extensions: permessage-deflate; client_max_window_bits")) {
            assertThat(socket.status()).isEqualTo(101);
            assertThat(socket.responseHead())
                    .noneMatch(line -> line.toLowerCase(java.util.Locale.ROOT).startsWith("sec-websocket-extensions"));
        }
    }

    @Test
    void a_client_that_stops_reading_does_not_slow_the_others() throws Exception {
        try (TestClient healthy = TestClient.connect(port)) {
            RawSocket[] stalled = new RawSocket[12]; // more than Spring's pools have threads
            for (int i = 0; i < stalled.length; i++) {
                stalled[i] = new RawSocket(port, Destinations.ENDPOINT);
                stalled[i].connectStomp();
                stalled[i].receive();
                stalled[i].send("SUBSCRIBE\nid:0\ndestination:/topic/bodies\n\n\0");
            }
            long first = healthy.frame().tick();
            int frames = 0;
            long last = first;
            while (last < first + 450) { // three seconds; their buffers are full after a fraction of one
                last = healthy.frame().tick();
                frames++;
            }

            assertThat(frames).isGreaterThan(60);
            for (RawSocket socket : stalled) {
                socket.close();
            }
        }
    }
}

package io.github.apsis.server.web;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse.BodyHandlers;
import java.nio.charset.StandardCharsets;
import java.time.Duration;

/** SockJS by xhr-streaming, one request at a time. */
final class SockJsByHand {
    private SockJsByHand() {}

    /** Connects, sends one STOMP frame, and returns the ERROR that comes back. */
    static String sendHuge(int port, String stomp) throws Exception {
        String session = "http://localhost:" + port + Destinations.ENDPOINT + "/000/" + System.nanoTime();
        HttpClient http = HttpClient.newHttpClient();
        var stream = http.send(request(session + "/xhr_streaming", ""), BodyHandlers.ofInputStream());
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(stream.body(), StandardCharsets.UTF_8))) {
            await(lines, "o");
            http.send(
                    request(session + "/xhr_send", "[\"CONNECT\\naccept-version:1.2\\n\\n\\u0000\"]"),
                    BodyHandlers.discarding());
            await(lines, "a[\"CONNECTED");
            String escaped = stomp.replace("\n", "\\n").replace("\0", "\\u0000");
            http.send(request(session + "/xhr_send", "[\"" + escaped + "\"]"), BodyHandlers.discarding());
            return await(lines, "a[\"ERROR");
        }
    }

    private static HttpRequest request(String url, String body) {
        return HttpRequest.newBuilder(URI.create(url))
                .timeout(Duration.ofSeconds(TestClient.PATIENCE_SECONDS))
                .POST(HttpRequest.BodyPublishers.ofString(body))
                .build();
    }

    private static String await(BufferedReader lines, String start) throws Exception {
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            if (line.startsWith(start)) {
                return line;
            }
        }
        throw new AssertionError("the stream ended before " + start);
    }
}

package io.github.apsis.benchmarks.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.benchmarks.ContactMode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RobustRunTest {
    @TempDir
    @SuppressWarnings("NullAway.Init") // set by JUnit before each test
    private Path folder;

    private RobustRow run(String oneCase) throws IOException {
        Files.writeString(folder.resolve("robust.json"), "{\"kind\": \"robust\", \"cases\": [" + oneCase + "]}");
        RobustCase input = ReferenceFolder.read(folder, id -> true).robust().get(0);
        return new RobustRun(input, ContactMode.TICK, 20).run();
    }

    @Test
    void two_points_that_cross_keep_their_speeds() throws IOException {
        RobustRow row = run(
                """
                {"id": "points", "G": 0, "bodies": [{"m": 1, "x": -1, "y": 0, "vx": 1}, {"m": 1, "x": 1, "y": 0, "vx": -1}],
                 "check": {"finite": true, "speeds": [1, 1]}}""");

        assertThat(row.status()).isEqualTo("ok");
    }

    @Test
    void a_check_that_does_not_hold_says_what_was_found() throws IOException {
        RobustRow row = run(
                """
                {"id": "points", "G": 0, "bodies": [{"m": 1, "x": -1, "y": 0, "vx": 1}], "check": {"speeds": [2]}}""");

        assertThat(row).isEqualTo(new RobustRow("points", "failed", "body 0 is at speed 1.0"));
    }

    @Test
    void a_mass_that_is_none_is_refused() throws IOException {
        RobustRow row = run("{\"id\": \"mass\", \"values\": [\"-1\", \"NaN\"], \"check\": {\"throws\": true}}");

        assertThat(row.status()).isEqualTo("ok");
        assertThat(row.outcome()).contains("refused");
    }
}

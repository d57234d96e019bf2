package io.github.apsis.benchmarks.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.benchmarks.accuracy.ReferenceFolder.Refusal;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ReferenceFolderTest {
    @TempDir
    @SuppressWarnings("NullAway.Init") // set by JUnit before each test
    private Path folder;

    @Test
    void the_cases_that_come_with_the_program_can_all_be_read() throws IOException {
        ReferenceFolder shipped = ReferenceFolder.shipped(id -> true);

        assertThat(shipped.orbits()).hasSize(14);
        assertThat(shipped.forces()).hasSize(4).allSatisfy(one -> assertThat(one.count())
                .isGreaterThanOrEqualTo(1000));
        assertThat(shipped.robust()).hasSize(25);
        assertThat(shipped.refusals()).isEmpty();
    }

    @Test
    void a_number_may_be_a_string() throws IOException {
        NBodyCase orbit = TwoBodyCase.read(folder);

        assertThat(orbit.g()).isEqualTo(1);
        assertThat(orbit.bodies().get(0).vy()).isEqualTo(0.5);
        assertThat(orbit.samples().get(0).x()[1]).isEqualTo(-0.5 * Math.cos(1));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{\"kind\": | failed: it is not JSON",
                "[1, 2] | failed: it is not a JSON object",
                "{\"id\": \"broken\"} | failed: it has no kind",
                "{\"kind\": \"nbody\", \"G\": 1} | failed: it has no conserved",
                "{\"kind\": \"force\", \"G\": 1, \"csv\": \"none.csv\"} | failed: its table none.csv cannot be read",
                "{\"kind\": \"weather\"} | skipped: the kind \"weather\" is not known here"
            })
    void a_file_that_cannot_be_used_says_why_and_stops_nothing(String content, String status) throws IOException {
        Files.writeString(folder.resolve("broken.json"), content);
        TwoBodyCase.write(folder, "circle");

        ReferenceFolder found = ReferenceFolder.read(folder, id -> true);

        assertThat(found.refusals()).extracting(Refusal::file).containsExactly("broken.json");
        assertThat(found.refusals().get(0).status()).startsWith(status);
        assertThat(found.orbits()).hasSize(1);
    }

    @Test
    void a_sample_with_a_body_too_few_is_refused() throws IOException {
        Path file = TwoBodyCase.write(folder, "circle");
        Files.writeString(file, Files.readString(file).replaceFirst("\"state\": \\[\\[[^]]*], ", "\"state\": ["));

        assertThat(ReferenceFolder.read(folder, id -> true).refusals().get(0).status())
                .isEqualTo("failed: its sample at 1.0 has 1 bodies and not 2");
    }

    @Test
    void contact_cases_are_named_and_left_alone() throws IOException {
        Files.writeString(folder.resolve("bump.json"), "{\"id\": \"bump\", \"kind\": \"contact\"}");

        ReferenceFolder found = ReferenceFolder.read(folder, id -> true);

        assertThat(found.contacts()).containsExactly("bump");
        assertThat(found.refusals()).isEmpty();
    }

    @Test
    void a_hard_input_that_cannot_be_read_leaves_the_others_of_its_file() throws IOException {
        Files.writeString(
                folder.resolve("robust.json"),
                """
                {"kind": "robust", "cases": [{"id": "empty"}, {"id": "points", "check": {"finite": true}}]}""");

        ReferenceFolder found = ReferenceFolder.read(folder, id -> true);

        assertThat(found.brokenRobust()).containsExactly(new RobustRow("empty", "failed", "it has no check"));
        assertThat(found.robust()).extracting(RobustCase::id).containsExactly("points");
    }
}

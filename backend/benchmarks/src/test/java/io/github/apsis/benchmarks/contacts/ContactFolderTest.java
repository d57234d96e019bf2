package io.github.apsis.benchmarks.contacts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import io.github.apsis.benchmarks.ContactMode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ContactFolderTest {
    @TempDir
    @SuppressWarnings("NullAway.Init") // set by JUnit before each test
    private Path folder;

    private List<ContactRow> rows() throws IOException {
        return ContactFolder.read(folder).jobs().stream()
                .flatMap(job -> job.rows().apply(ContactMode.TICK).stream())
                .toList();
    }

    @Test
    void the_cases_that_come_with_the_program_can_all_be_read() throws IOException {
        ContactFolder shipped = ContactFolder.shipped();

        assertThat(shipped.contacts()).hasSize(16).extracting(ContactCase::id).contains("gas100", "planet-drop");
        assertThat(shipped.jobs()).hasSize(16 + 10 + 1); // ten outcomes, and the file of hard inputs
        assertThat(shipped.others()).isZero();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "{\"kind\": | failed: it is not JSON",
                "[1, 2] | failed: it is not a JSON object",
                "{\"id\": \"broken\"} | failed: it has no kind",
                "{\"kind\": \"contact\"} | failed: it has no bodies",
                "{\"kind\": \"contact\", \"restitution\": 1, \"bodies\": [], \"samples\": []} | failed: it has no bodies",
                "{\"kind\": \"contact\", \"friction\": 0.5} | failed: it has friction, which no contact here has",
                "{\"kind\": \"outcomes\", \"cases\": [{\"id\": \"x\"}]} | failed: it has no bodies",
                "{\"kind\": \"weather\"} | skipped: the kind \"weather\" is not known here"
            })
    void a_file_that_cannot_be_used_says_why_and_stops_nothing(String content, String status) throws IOException {
        Files.writeString(folder.resolve("broken.json"), content);
        HeadOnCase.write(folder, "bump");

        assertThat(rows()).extracting(ContactRow::caseId).last().isEqualTo("bump");
        assertThat(rows().get(0).caseId()).startsWith("broken");
        assertThat(rows().get(0).status()).startsWith(status);
        assertThat(rows()).hasSize(2);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "\"j\": 0 | \"j\": 2 | failed: an event is of a body that is not there: 2",
                "\"j\": 0 | \"j\": \"w1\" | failed: an event is of a wall that is not there: \"w1\"",
                "\"t\": \"1.5\" | \"t\": \"soon\" | failed: not a number: soon",
                "\"t\": 1, | \"t\": 9, | failed: its samples are not in order of time: 2.5",
                ", [2, 0, 0, 0]] | ] | failed: its sample at 1.0 has 1 bodies and not 2",
                "\"restitution\": \"0.5\" | \"restitution\": 2 | failed: its restitution must be 0 to 1, was 2.0",
                "\"nx\": 1 | \"nx\": 0 | failed: the normal of a wall must have a direction, was (0.0, 0.0)"
            })
    void a_case_with_a_flaw_says_which(String from, String to, String status) throws IOException {
        Path file = HeadOnCase.write(folder, "bump");
        Files.writeString(file, Files.readString(file).replace(from, to));

        assertThat(rows()).extracting(ContactRow::status).containsExactly(status);
    }

    @Test
    void kinds_that_are_measured_elsewhere_are_counted_and_left_alone() throws IOException {
        Files.writeString(folder.resolve("orbit.json"), "{\"kind\": \"nbody\"}");
        HeadOnCase.write(folder, "bump");

        assertThat(ContactFolder.read(folder).others()).isEqualTo(1);
        assertThat(rows()).hasSize(1);
    }

    @Test
    void of_hard_inputs_those_about_contacts_are_run() throws IOException {
        Files.writeString(
                folder.resolve("robust.json"),
                """
                {"id": "robust", "kind": "robust", "default_ticks": 20, "cases": [
                  {"id": "pulled", "G": 1, "bodies": [{"m": 1, "r": 1, "x": 0, "y": 0}], "check": {"finite": true}},
                  {"id": "touching", "G": 0, "check": {"bitwise_unchanged": true},
                   "bodies": [{"m": 1, "r": 1, "x": 0, "y": 0}, {"m": 1, "r": 1, "x": 2, "y": 0}]},
                  {"id": "unreadable"}]}""");

        assertThat(rows())
                .extracting(ContactRow::caseId, ContactRow::status)
                .containsExactly(tuple("robust/touching", "ok"), tuple("robust/unreadable", "failed: it has no check"));
    }
}

package io.github.apsis.benchmarks.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

class ContactsCommandTest {
    private static final int OK = 0;
    private static final int NOT_WELL = 1;
    private static final int USAGE = 2;
    private static final String HEADER =
            "case,mode,events_in_order,max_time_error,max_position_error,max_velocity_error,energy_change,momentum_error,status";

    @TempDir
    @SuppressWarnings("NullAway.Init") // set by JUnit before each test
    private Path folder;

    @TempDir
    @SuppressWarnings("NullAway.Init") // set by JUnit before each test
    private Path cases;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        CommandLine line = ApsisBench.commandLine();
        line.setOut(new PrintWriter(out));
        line.setErr(new PrintWriter(err));
        return line.execute(arguments);
    }

    @BeforeEach
    void a_disc_meets_another() throws IOException {
        Files.writeString(
                cases.resolve("bump.json"),
                """
                {"id": "bump", "kind": "contact", "restitution": 1,
                 "bodies": [{"m": 1, "r": 0.25, "x": 0, "y": 0, "vx": 1, "vy": 0},
                            {"m": 1, "r": 0.25, "x": 2, "y": 0, "vx": 0, "vy": 0}],
                 "events": [{"t": 1.5, "i": 0, "j": 1, "vn": -1}],
                 "samples": [{"t": 2.5, "state": [[1.5, 0, 0, 0], [3, 0, 1, 0]]}]}""");
    }

    @Test
    void a_folder_of_cases_gives_a_row_for_each_mode_and_a_page() throws IOException {
        int code = run("contacts", "--cases", cases.toString(), "--out", folder.toString());

        assertThat(code).as(err.toString()).isEqualTo(OK);
        List<String> lines = Files.readAllLines(folder.resolve("contacts.csv"));
        assertThat(lines).hasSize(3).first().isEqualTo(HEADER);
        assertThat(lines.get(1)).startsWith("bump,tick,1/1,").endsWith(",ok");
        assertThat(lines.get(2)).startsWith("bump,exact,1/1,").endsWith(",ok");
        assertThat(folder.resolve("README.md"))
                .content()
                .contains("| bump | tick | 1/1 |", "| bump | exact | 1/1 |", "exact: 1 of 1 ok");
        assertThat(folder.resolve("scenes.csv")).doesNotExist(); // other engines run beside our own cases
        assertThat(out.toString()).contains("tick: 1 of 1 ok");
    }

    @Test
    void without_a_place_for_files_the_table_is_printed() {
        assertThat(run("contacts", "--cases", cases.toString())).isEqualTo(OK);
        assertThat(out.toString()).startsWith(HEADER).contains("bump,tick,1/1,");
    }

    @Test
    void a_damaged_file_fails_in_one_line_and_the_others_run() throws IOException {
        Files.writeString(cases.resolve("odd.json"), "{\"kind\": \"contact\"");

        assertThat(run("contacts", "--cases", cases.toString())).isEqualTo(NOT_WELL);

        assertThat(err.toString()).contains("odd, tick: failed: it is not JSON").doesNotContain("\tat ");
        assertThat(out.toString())
                .contains("odd,tick,,,,,,,failed: it is not JSON")
                .contains("bump,tick,1/1,");
    }

    @Test
    void other_kinds_are_left_out_with_one_note() throws IOException {
        Files.writeString(cases.resolve("orbit.json"), "{\"kind\": \"nbody\"}");
        Files.writeString(cases.resolve("pull.json"), "{\"kind\": \"force\"}");

        assertThat(run("contacts", "--cases", cases.toString())).isEqualTo(OK);

        assertThat(err.toString()).contains("2 files of other kinds are not run here");
    }

    @Test
    void a_folder_that_is_not_there_is_a_usage_error() {
        assertThat(run("contacts", "--cases", "/no/such/folder")).isEqualTo(USAGE);
        assertThat(err.toString()).contains("--cases must be a folder").doesNotContain("\tat ");
    }

    @Test
    void an_empty_folder_is_a_usage_error() {
        assertThat(run("contacts", "--cases", folder.toString())).isEqualTo(USAGE);
        assertThat(err.toString()).contains("There are no contact cases in that folder.");
    }

    @Test
    void the_help_says_what_comes_out() {
        assertThat(run("contacts", "--help")).isEqualTo(OK);
        assertThat(out.toString()).contains("contacts.csv", "dyn4j", "--short");
    }
}

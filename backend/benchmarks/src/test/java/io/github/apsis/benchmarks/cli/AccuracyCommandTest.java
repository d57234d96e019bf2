package io.github.apsis.benchmarks.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

class AccuracyCommandTest {
    private static final int OK = 0;
    private static final int NOT_WELL = 1;
    private static final int USAGE = 2;

    @TempDir
    @SuppressWarnings("NullAway.Init") // set by JUnit before each test
    private Path folder;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        CommandLine line = ApsisBench.commandLine();
        line.setOut(new PrintWriter(out));
        line.setErr(new PrintWriter(err));
        return line.execute(arguments);
    }

    @Test
    void a_short_run_of_one_case_writes_tables_plots_and_a_page() throws IOException {
        int code = run(
                "accuracy",
                "--short",
                "--case",
                "figure8",
                "--method",
                "leapfrog",
                "--python",
                "no-such-python",
                "--out",
                folder.toString());

        assertThat(code).as(err.toString()).isEqualTo(OK);
        assertThat(Files.readAllLines(folder.resolve("accuracy.csv")))
                .hasSize(3)
                .allMatch(line -> line.startsWith("case,") || line.endsWith(",ok"));
        assertThat(folder.resolve("force.csv")).exists();
        assertThat(folder.resolve("robust.csv")).exists();
        assertThat(folder.resolve("rebound.csv")).exists();
        assertThat(folder.resolve("step.csv")).content().contains("3,apsis,");
        assertThat(folder.resolve("plots/speed-figure8-energy.png")).isNotEmptyFile();
        assertThat(folder.resolve("README.md"))
                .content()
                .contains("| figure8 |", "Without REBOUND", "2 orbit rows: 2 ok");
        assertThat(err.toString()).contains("no REBOUND");
    }

    @Test
    void a_folder_with_a_broken_file_fails_in_one_line() throws IOException {
        Files.writeString(folder.resolve("odd.json"), "{\"kind\": \"nbody\"");

        assertThat(run("accuracy", "--cases", folder.toString(), "--python", "no-such-python"))
                .isEqualTo(NOT_WELL);

        assertThat(err.toString()).contains("odd.json failed: it is not JSON").doesNotContain("\tat ");
        assertThat(out.toString()).contains("odd,,,,,,,,").contains("1 failed");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "--method magic",
                "--dt 0",
                "--dt soon",
                "--tolerance -1",
                "--cases /no/such/folder",
                "--case no-such-case --python no-such-python"
            })
    void what_makes_no_sense_is_a_usage_error(String arguments) {
        assertThat(run(("accuracy " + arguments).split(" "))).isEqualTo(USAGE);
        assertThat(err.toString()).doesNotContain("\tat ");
    }

    @Test
    void an_empty_folder_is_a_usage_error() {
        assertThat(run("accuracy", "--cases", folder.toString())).isEqualTo(USAGE);
        assertThat(err.toString()).contains("no nbody, force or robust cases");
    }
}

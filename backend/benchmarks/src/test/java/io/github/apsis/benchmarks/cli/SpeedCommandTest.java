package io.github.apsis.benchmarks.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

class SpeedCommandTest {
    private static final int OK = 0;
    private static final int USAGE = 2;
    private static final String HEADER =
            "scene,engine,n,threads,jdk,ms_per_step,p99_ms,alloc_bytes_per_step,error_kind,error";

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
    void a_folder_gets_a_table_a_page_and_a_plot() throws IOException {
        int code = run("speed", "--glimpse", "--scene", "broad-phase", "--out", folder.toString());

        assertThat(code).as(err.toString()).isEqualTo(OK);
        List<String> lines = Files.readAllLines(folder.resolve("speed.csv"));
        assertThat(lines).hasSizeGreaterThan(3).first().isEqualTo(HEADER);
        assertThat(lines.get(1)).startsWith("broad-phase,apsis,10,1," + System.getProperty("java.version") + ",");
        assertThat(folder.resolve("README.md"))
                .content()
                .contains("## broad-phase", "| 100 | jts-quadtree |", "--out docs/performance", "ms_per_step");
        assertThat(folder.resolve("plots")).isNotEmptyDirectory();
    }

    @Test
    void without_a_place_for_files_the_table_is_printed() {
        assertThat(run("speed", "--glimpse", "--scene", "s3-direct")).isEqualTo(OK);
        assertThat(out.toString()).startsWith(HEADER).contains("s3-direct,apsis,100,1,");
    }

    @Test
    void a_scene_that_is_not_there_is_a_usage_error() {
        assertThat(run("speed", "--scene", "s9")).isEqualTo(USAGE);
        assertThat(err.toString())
                .contains("There is no scene s9.", "s1-gas", "moonshot")
                .doesNotContain("\tat ");
    }

    @Test
    void several_threads_step_the_scenes_that_can_use_them() {
        assertThat(run("speed", "--glimpse", "--scene", "s3-direct", "--scene", "frames", "--threads", "2"))
                .isEqualTo(OK);
        assertThat(out.toString()).contains("s3-direct,apsis,100,2,").doesNotContain("frames");

        assertThat(run("speed", "--glimpse", "--scene", "frames", "--threads", "2"))
                .isEqualTo(USAGE);
        assertThat(run("speed", "--threads", "0")).isEqualTo(USAGE);
        assertThat(err.toString())
                .contains(
                        "None of these scenes can be stepped by several threads.",
                        "--threads must be 1 or more, was 0");
    }

    @Test
    void the_help_says_what_comes_out() {
        assertThat(run("speed", "--help")).isEqualTo(OK);
        assertThat(out.toString()).contains("speed.csv", "--short", "--scene");
    }
}

package io.github.apsis.benchmarks.cli;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.scenes.SceneCatalogue;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;

class ApsisBenchTest {
    private static final int OK = 0;
    private static final int USAGE = 2;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        CommandLine line = ApsisBench.commandLine();
        line.setOut(new PrintWriter(out));
        line.setErr(new PrintWriter(err));
        return line.execute(arguments);
    }

    @Test
    void help_names_the_commands() {
        assertThat(run("--help")).isEqualTo(OK);
        assertThat(out.toString()).contains("apsis-bench", "run", "list");
    }

    @Test
    void the_help_of_run_says_that_seconds_are_simulated() {
        assertThat(run("run", "--help")).isEqualTo(OK);
        assertThat(out.toString()).contains("Simulated seconds");
    }

    @Test
    void version_names_the_program_and_the_jdk() {
        assertThat(run("--version")).isEqualTo(OK);
        assertThat(out.toString()).startsWith("apsis-bench ").contains("JDK " + Runtime.version());
    }

    @Test
    void a_run_reports_speed_error_allocation_and_state() {
        assertThat(run("run", "two-bodies", "--seconds", "2")).isEqualTo(OK);

        assertThat(out.toString().lines().map(line -> line.substring(0, 18).strip()))
                .containsExactly(
                        "scene",
                        "bodies",
                        "machine",
                        "threads",
                        "ticks",
                        "ticks per second",
                        "real-time factor",
                        "time per tick",
                        "allocated",
                        "energy",
                        "energy drift",
                        "momentum drift",
                        "angular drift",
                        "overlap",
                        "touching pairs",
                        "state hash");
        assertThat(out.toString())
                .contains("two-bodies, seed 1", "300, after 300 to warm up")
                .containsPattern("p50 [0-9.]+ µs, p99 [0-9.]+ µs, max [0-9.]+ µs")
                .containsPattern("energy drift +[+-][0-9.]+e-[0-9]+");
        assertThat(err.toString()).isEmpty();
    }

    @Test
    void the_same_scene_seed_and_time_end_in_the_same_state() {
        assertThat(hashOf("elastic-gas", "1"))
                .isEqualTo(hashOf("elastic-gas", "1"))
                .isNotEqualTo(hashOf("elastic-gas", "2"));
    }

    @Test
    void any_number_of_threads_ends_in_the_same_state() {
        assertThat(hashOf("belt-and-swarm", "1", "--threads", "2")).isEqualTo(hashOf("belt-and-swarm", "1"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "-1", "257", "many"})
    void a_number_of_threads_that_makes_no_sense_is_a_usage_error(String threads) {
        assertThat(run("run", "two-bodies", "--threads", threads)).isEqualTo(USAGE);
        assertThat(err.toString()).contains("--threads");
    }

    @Test
    void a_program_can_read_the_report() {
        assertThat(run("run", "elastic-gas", "--bodies", "20", "--seconds", "1", "--json"))
                .isEqualTo(OK);

        assertThat(out.toString().strip())
                .startsWith("{\"scene\":\"elastic-gas\",\"seed\":1,\"bodies\":20,")
                .containsPattern("\"ticks\":150,\"warmUpTicks\":150,\"ticksPerSecond\":[0-9.]+,")
                .containsPattern("\"stateHash\":\"[0-9a-f]{16}\"}$");
    }

    @ParameterizedTest
    @ValueSource(strings = {"run", "run flatland"})
    void without_a_scene_that_exists_all_scenes_are_listed(String arguments) {
        assertThat(run(arguments.split(" "))).isEqualTo(USAGE);

        assertThat(SceneCatalogue.all())
                .allSatisfy(scene -> assertThat(err.toString()).contains(scene.name(), scene.title()));
        assertThat(out.toString()).isEmpty();
    }

    @Test
    void list_lists_all_scenes() {
        assertThat(run("list")).isEqualTo(OK);
        assertThat(SceneCatalogue.all())
                .allSatisfy(scene -> assertThat(out.toString()).contains(scene.name(), scene.title()));
    }

    @Test
    void a_scene_of_one_size_takes_no_number_of_bodies() {
        assertThat(run("run", "two-bodies", "--bodies", "5")).isEqualTo(USAGE);
        assertThat(err.toString()).contains("two-bodies comes in one size only");
    }

    @ParameterizedTest
    @ValueSource(strings = {"0", "-1", "NaN", "soon"})
    void a_time_that_makes_no_sense_is_a_usage_error(String seconds) {
        assertThat(run("run", "two-bodies", "--seconds", seconds)).isEqualTo(USAGE);
        assertThat(err.toString()).contains("--seconds");
    }

    private String hashOf(String scene, String seed, String... options) {
        out.getBuffer().setLength(0);
        List<String> arguments =
                new ArrayList<>(List.of("run", scene, "--bodies", "30", "--seconds", "1", "--seed", seed));
        arguments.addAll(List.of(options));
        assertThat(run(arguments.toArray(String[]::new))).isEqualTo(OK);
        Matcher hash = Pattern.compile("state hash +([0-9a-f]{16})").matcher(out.toString());
        assertThat(hash.find()).isTrue();
        return hash.group(1);
    }
}

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

class SteeringCommandTest {
    private static final int OK = 0;
    private static final int USAGE = 2;
    private static final String HEADER =
            "scene,method,seeds,collisions_per_min,hit_pct,min_clearance,arrived_pct,time_ratio,jerk,turn,cost_ms_per_1000";
    private static final String HEAD_ON =
            """
            {"scene":"headon","seed":0,"maxTicks":3000,"wrap":[0.0,0.0],"box":0.0,"wander":false,"dock":true,
             "checksum":"907abaf384069f65",
             "ships":{"x":[-400,400],"y":[0,0],"vx":[0,0],"vy":[0,0],"gx":[400,-400],"gy":[0,0]},
             "bodies":{"kind":[],"x":[],"y":[],"vx":[],"vy":[],"r":[],"mu":[],"omega":[]}}""";

    @TempDir
    @SuppressWarnings("NullAway.Init") // set by JUnit before each test
    private Path folder;

    @TempDir
    @SuppressWarnings("NullAway.Init") // set by JUnit before each test
    private Path instances;

    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int run(String... arguments) {
        CommandLine line = ApsisBench.commandLine();
        line.setOut(new PrintWriter(out));
        line.setErr(new PrintWriter(err));
        return line.execute(arguments);
    }

    @Test
    void scenes_by_name_give_a_row_for_every_method() throws IOException {
        int code = run("steering", "--scenes", "headon,arrival", "--out", folder.toString());

        assertThat(code).as(err.toString()).isEqualTo(OK);
        List<String> lines = Files.readAllLines(folder.resolve("steering.csv"));
        assertThat(lines).hasSize(1 + 2 * 8).first().isEqualTo(HEADER);
        assertThat(lines.get(1)).startsWith("headon,apsis,0-4,0.00000,0.000,");
        assertThat(lines.get(5)).startsWith("headon,gdx-ai-priority,0-4,");
        assertThat(Files.readAllLines(folder.resolve("arrival.csv"))).hasSize(1 + 24 * 8);
        assertThat(folder.resolve("table.md")).content().contains("| headon | apsis | 0-4 |");
        assertThat(folder.resolve("plots/collisions-against-time.svg"))
                .content()
                .contains(">headon<", ">apsis<");
        assertThat(out.toString()).contains("apsis: no collision in 2 of 2 scenes");
    }

    @Test
    void a_folder_of_instances_needs_no_code() throws IOException {
        Files.writeString(instances.resolve("mine.json"), HEAD_ON.replace("\"headon\"", "\"mine\""));
        Files.writeString(instances.resolve("checksums.json"), "{\"headon\": []}");

        assertThat(run("steering", "--scenes", instances.toString(), "--method", "apsis"))
                .isEqualTo(OK);

        assertThat(out.toString()).startsWith(HEADER).contains("mine,apsis,0,0.00000,");
    }

    @Test
    void an_instance_whose_checksum_is_another_is_refused() throws IOException {
        Files.writeString(instances.resolve("mine.json"), HEAD_ON.replace("-400,400", "-400,401"));

        assertThat(run("steering", "--scenes", instances.toString())).isEqualTo(USAGE);

        assertThat(err.toString()).contains("mine.json: its checksum is").doesNotContain("\tat ");
    }

    @Test
    void names_and_seeds_that_make_no_sense_are_usage_errors() {
        assertThat(run("steering", "--scenes", "nowhere")).isEqualTo(USAGE);
        assertThat(run("steering", "--method", "luck")).isEqualTo(USAGE);
        assertThat(run("steering", "--seeds", "one")).isEqualTo(USAGE);
        assertThat(err.toString())
                .contains("there is no scene nowhere", "there is no method luck", "--seeds must look like")
                .doesNotContain("\tat ");
    }
}

package io.github.apsis.benchmarks.speed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SpeedTableTest {
    @TempDir
    @SuppressWarnings("NullAway.Init") // set by JUnit before each test
    private Path folder;

    private static SpeedRow row(String scene, String jdk, double ms) {
        return new SpeedRow(scene, "apsis", 1000, 1, jdk, ms, 2 * ms, 0, "overlap", 1e-9);
    }

    @Test
    void a_row_reads_back_as_it_was_written() {
        SpeedRow row = row("s1-gas", "17.0.15", 0.25);

        assertThat(row.csv()).isEqualTo("s1-gas,apsis,1000,1,17.0.15,2.5000e-01,5.0000e-01,0,overlap,1.0000e-09");
        assertThat(SpeedRow.parse(row.csv())).isEqualTo(row);
    }

    @Test
    void a_run_replaces_its_own_jdk_and_scenes_and_keeps_the_rest() {
        SpeedTable before = SpeedTable.empty()
                .with(List.of(row("ships", "17.0.14", 1), row("s1-gas", "17.0.14", 2), row("s1-gas", "25.0.3", 3)));

        SpeedTable after = before.with(List.of(row("s1-gas", "17.0.15", 4)));

        assertThat(after.rows())
                .containsExactly(row("s1-gas", "17.0.15", 4), row("s1-gas", "25.0.3", 3), row("ships", "17.0.14", 1));
    }

    @Test
    void one_thread_and_two_stand_side_by_side() {
        SpeedRow two = new SpeedRow("s3-tree", "apsis", 1000, 2, "25.0.3", 1, 2, 0, "force-rms", 1e-6);

        SpeedTable table =
                SpeedTable.empty().with(List.of(row("s3-tree", "25.0.3", 2))).with(List.of(two));

        assertThat(table.rows()).extracting(SpeedRow::contender).containsExactly("apsis", "apsis, 2 threads");
    }

    @Test
    void another_table_is_not_overwritten() throws IOException {
        Path file = Files.writeString(folder.resolve("speed.csv"), "distance,time\n1,2\n");

        assertThatThrownBy(() -> SpeedTable.read(file)).hasMessageContaining("is not a table of speeds");
        assertThat(SpeedTable.read(folder.resolve("none.csv")).rows()).isEmpty();
    }
}

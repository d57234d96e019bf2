package io.github.apsis.benchmarks.speed;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.apsis.benchmarks.speed.SpeedStudy.Length;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class SpeedSceneTest {
    private static List<SpeedRow> rows(String scene) {
        List<SpeedRow> rows = new ArrayList<>();
        List<String> progress = new ArrayList<>();
        Bench bench = new Bench(Length.GLIMPSE, 1, rows::add, progress::add);
        SpeedScenes.named(List.of(scene)).forEach(one -> one.run(bench));
        assertThat(progress).noneMatch(line -> line.contains("failed"));
        return rows;
    }

    private static double error(List<SpeedRow> rows, String engine, String kind) {
        return rows.stream()
                .filter(row -> row.engine().equals(engine) && row.errorKind().equals(kind))
                .mapToDouble(SpeedRow::error)
                .max()
                .orElseThrow();
    }

    @Test
    void a_gas_runs_in_all_engines_and_ours_keeps_its_energy() {
        List<SpeedRow> rows = rows("s1-gas");

        assertThat(rows)
                .extracting(SpeedRow::engine)
                .contains("apsis", "dyn4j", "dyn4j-bullets-only", "dyn4j-discrete", "jbox2d");
        assertThat(error(rows, "apsis", "energy-drift")).isLessThan(1e-13);
        assertThat(error(rows, "apsis", "overlap")).isLessThan(1e-6);
        assertThat(error(rows, "jbox2d", "energy-drift")).isPositive(); // single precision
        assertThat(rows).allSatisfy(row -> {
            assertThat(row.msPerStep()).isPositive();
            assertThat(row.p99Ms()).isPositive();
            assertThat(row.threads()).isEqualTo(1);
        });
    }

    @Test
    void gravity_is_exact_where_it_is_summed_directly_and_near_where_it_is_not() {
        assertThat(error(rows("s3-direct"), "apsis", "force-worst")).isLessThan(1e-13);
        assertThat(error(rows("s3-tree"), "apsis", "force-rms")).isBetween(1e-12, 1e-4);
    }

    /** The world's sums, and no object: once the compiler has settled, which a glimpse gives no time for. */
    @Test
    void a_sum_of_forces_allocates_nothing() {
        MassDisc disc = new MassDisc(100, 1000, 1);
        ForceCourse course = new ForceCourse(disc.world(disc.laws().build()));

        StepCost cost = Trial.lasting(200, course::step).run(course, 1).cost();

        assertThat(cost.bytes()).isLessThan(1); // a step; a compiler that gives up its code copies some bytes once
    }

    @Test
    void every_scene_has_a_name_of_its_own_and_says_what_it_is() {
        assertThat(SpeedScenes.names())
                .doesNotHaveDuplicates()
                .contains("s1-gas", "s2-pile", "s3-direct", "s3-tree", "disc-10k", "broad-phase", "ships")
                .contains("default-tick", "hundred-rooms", "moonshot", "frames");
        assertThat(SpeedScenes.all())
                .allSatisfy(scene -> assertThat(scene.description()).isNotBlank());
        assertThatThrownBy(() -> SpeedScenes.named(List.of("s9")))
                .hasMessageContaining("There is no scene s9")
                .hasMessageContaining("s1-gas");
    }
}

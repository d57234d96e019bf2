package io.github.apsis.benchmarks.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class RowsTest {
    private static final OrbitRow OURS =
            new OrbitRow("figure8", "leapfrog", 1.0 / 150, Double.NaN, 7.5, 2.6e-5, 1e-14, 1.5e-2, "ok");
    private static final OrbitRow PEER =
            new OrbitRow("figure8", "rebound-leapfrog", 1.0 / 150, Double.NaN, 15, 2.2e-6, 1e-14, 2.7e-2, "ok");

    @Test
    void the_columns_are_those_that_others_read() {
        assertThat(OrbitRow.HEADER)
                .isEqualTo("case,method,dt,tolerance,cpu_us_per_unit,energy_error,L_error,position_error,status");
        assertThat(ForceRow.HEADER).isEqualTo("case,solver,theta,median,p99,max,rms,net_force,ms");
        assertThat(RobustRow.HEADER).isEqualTo("id,status,outcome");
        assertThat(StepCost.HEADER).isEqualTo("bodies,engine,ns_per_step");
    }

    @Test
    void a_row_reads_back_as_it_was_written() {
        assertThat(OURS.csv())
                .isEqualTo("figure8,leapfrog,0.006666666666666667,,7.5000e+00,2.6000e-05,1.0000e-14,1.5000e-02,ok");
        assertThat(OrbitRow.parse(OURS.csv())).isEqualTo(OURS);
    }

    @Test
    void a_status_with_a_comma_stays_one_cell() {
        OrbitRow row = OrbitRow.without("x", "failed: a \"b\", c");

        assertThat(OrbitRow.parse(row.csv()).status()).isEqualTo("failed: a \"b\", c");
    }

    @Test
    void a_leapfrog_step_costs_its_share_of_a_unit() {
        List<StepCost> costs = StepCost.of(List.of(OURS), List.of(PEER), Map.of("figure8", 3));

        assertThat(costs).extracting(StepCost::engine).containsExactly("apsis", "rebound");
        assertThat(costs.get(0).nanos()).isCloseTo(50, within(1e-9)); // 7.5 µs / 150
    }

    @Test
    void equal_cpu_compares_only_what_costs_no_more() {
        var rule = new EqualCpu(List.of(OURS), List.of(PEER), OrbitRow::positionError);

        assertThat(rule.cell("figure8", 5)).isEqualTo("–");
        assertThat(rule.cell("figure8", 10)).isEqualTo("2e-2");
        assertThat(rule.cell("figure8", 20)).isEqualTo("2e-2 / 3e-2 (**1.8×**)");
    }

    @Test
    void force_errors_are_those_of_the_reference() {
        double[] none = {0, 0};
        var truth = new ForceCase(
                "pair", 1, new double[] {1, 1}, new double[] {0, 1}, none, new double[] {1, -1}, none, Path.of("pair"));

        ForceRow row = ForceRow.of(truth, "direct", Double.NaN, new double[] {1.1, -1}, none, 2);

        assertThat(row.max()).isCloseTo(0.1, within(1e-12));
        assertThat(row.rms()).isCloseTo(0.1 / Math.sqrt(2), within(1e-12)); // √(0.1²) / √(1² + 1²)
        assertThat(row.netForce()).isCloseTo(0.1 / 2.1, within(1e-12));
        assertThat(row.csv()).startsWith("pair,direct,,").endsWith(",2.0000e+00");
    }
}

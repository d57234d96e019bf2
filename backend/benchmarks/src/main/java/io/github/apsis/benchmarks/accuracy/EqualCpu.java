package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.report.Cells;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.ToDoubleFunction;

/** The rule of equal CPU: for a budget of CPU time per unit, our smallest error beside the peer's smallest. */
record EqualCpu(List<OrbitRow> ours, List<OrbitRow> peers, ToDoubleFunction<OrbitRow> error) {
    private static final double LOST = 1;
    static final int[] BUDGETS = {10, 20, 50, 100, 300}; // µs

    /** {@code 1e-13 / 4e-14 (0.4)}: ours, the peer's, and how many times smaller ours is. */
    String cell(String caseId, int budget) {
        Optional<OrbitRow> our = best(ours, caseId, budget);
        Optional<OrbitRow> their = best(peers, caseId, budget);
        String left = our.map(row -> brief(error.applyAsDouble(row))).orElse("–");
        if (their.isEmpty()) {
            return left;
        }
        String right = brief(error.applyAsDouble(their.get()));
        return our.isEmpty() ? left + " / " + right : left + " / " + right + " (" + ratio(our.get(), their.get()) + ")";
    }

    private String ratio(OrbitRow our, OrbitRow their) {
        double times = error.applyAsDouble(their) / error.applyAsDouble(our);
        if (Double.isNaN(times) || Double.isInfinite(times)) {
            return "–";
        }
        if (error.applyAsDouble(our) > LOST) {
            return "–"; // between two that lost the orbit there is nothing to compare
        }
        String text = Cells.times(times) + "×";
        return times > 1 ? "**" + text + "**" : text;
    }

    /** The setting with the smallest error that costs no more; empty when all cost more. */
    Optional<OrbitRow> best(List<OrbitRow> rows, String caseId, int budget) {
        return rows.stream()
                .filter(row -> row.caseId().equals(caseId) && row.isMeasured() && row.cpuMicrosPerUnit() <= budget)
                .filter(row -> Double.isFinite(error.applyAsDouble(row)))
                .min(Comparator.comparingDouble(error));
    }

    private static String brief(double error) {
        return error > LOST ? "lost" : String.format(Locale.ROOT, "%.0e", error).replace("e-0", "e-");
    }
}

package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.benchmarks.report.Csv;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;

/** One line of {@code step.csv}: what a leapfrog step costs with so many bodies. */
record StepCost(int bodies, String engine, double nanos) {
    static final String HEADER = "bodies,engine,ns_per_step";
    static final String APSIS = "apsis";
    static final String REBOUND = "rebound";

    /** The cheapest leapfrog step among all cases of a size, from the rows that were measured anyway. */
    static List<StepCost> of(List<OrbitRow> ours, List<OrbitRow> peers, Map<String, Integer> bodiesOfCase) {
        Map<Integer, List<String>> bySize = new TreeMap<>();
        bodiesOfCase.forEach((id, size) ->
                bySize.computeIfAbsent(size, n -> new ArrayList<>()).add(id));
        List<StepCost> costs = new ArrayList<>();
        bySize.forEach((size, ids) -> {
            cheapest(ours, Method.LEAPFROG.label(), ids).ifPresent(ns -> costs.add(new StepCost(size, APSIS, ns)));
            cheapest(peers, "rebound-leapfrog", ids).ifPresent(ns -> costs.add(new StepCost(size, REBOUND, ns)));
        });
        return costs;
    }

    private static OptionalDouble cheapest(List<OrbitRow> rows, String method, List<String> ids) {
        return rows.stream()
                .filter(row -> row.method().equals(method) && ids.contains(row.caseId()) && row.isMeasured())
                .mapToDouble(row -> row.cpuMicrosPerUnit() * row.dt() * 1e3)
                .min();
    }

    String csv() {
        return Csv.line(String.valueOf(bodies), engine, Cells.figure(nanos));
    }
}

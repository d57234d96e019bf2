package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.benchmarks.report.Markdown;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/** The part of the report about orbits: what a room gets, what a budget buys, what a step costs. */
final class OrbitSections {
    private final Results results;
    private final List<Method> only;
    private final Markdown page;

    OrbitSections(Results results, List<Method> only, Markdown page) {
        this.results = results;
        this.only = only;
        this.page = page;
    }

    void write() {
        if (!cases().isEmpty()) {
            settings();
            equalCpu();
            steps();
        }
    }

    private void settings() {
        page.paragraph("All rows: [accuracy.csv](accuracy.csv), [rebound.csv](rebound.csv), [force.csv](force.csv), "
                + "[robust.csv](robust.csv), [step.csv](step.csv).");
        page.paragraph("## At a room's tick, dt = 1/150");
        page.paragraph(
                "Energy error / position error at the last sample. \"lost\": an error of the whole energy or more. The "
                        + "adaptive method runs at its default tolerance.");
        List<String> methods = only.stream().map(Method::label).toList();
        List<List<String>> rows = new ArrayList<>();
        for (String id : cases()) {
            List<String> row = new ArrayList<>(List.of(id));
            methods.forEach(method -> row.add(atRoomTick(id, method)));
            rows.add(row);
        }
        page.table(Stream.concat(Stream.of("case"), methods.stream()).toList(), rows);
    }

    private String atRoomTick(String id, String method) {
        return results.orbits.stream()
                .filter(row -> row.caseId().equals(id) && row.method().equals(method) && row.isMeasured())
                .filter(row -> Math.abs(row.dt() / Ladder.ROOM - 1) < 1e-3)
                .map(row -> row.energyError() > 1
                        ? "lost"
                        : Cells.brief(row.energyError()) + " / " + Cells.brief(row.positionError()))
                .findFirst()
                .orElse("–");
    }

    private void equalCpu() {
        page.paragraph("## Equal CPU");
        page.paragraph(
                """
                For a budget of CPU time per unit of simulated time: the smallest error of any of our settings / that of any \
                of REBOUND's, and how many times smaller ours is (bold where it is). The rule reads both sides by their error \
                alone, in hindsight: it says what a method can reach, not what a user would have chosen.""");
        page.paragraph("Energy error:");
        equalCpu(new EqualCpu(results.orbits, results.peerOrbits, OrbitRow::energyError));
        page.paragraph("Position error at the last sample:");
        equalCpu(new EqualCpu(results.orbits, results.peerOrbits, OrbitRow::positionError));
    }

    private void equalCpu(EqualCpu rule) {
        List<String> head = new ArrayList<>(List.of("case"));
        Arrays.stream(EqualCpu.BUDGETS).forEach(budget -> head.add(budget + " µs"));
        page.table(
                head,
                cases().stream()
                        .map(id -> Stream.concat(
                                        Stream.of(id),
                                        Arrays.stream(EqualCpu.BUDGETS).mapToObj(budget -> rule.cell(id, budget)))
                                .toList())
                        .toList());
    }

    private void steps() {
        if (results.stepCosts.isEmpty()) {
            return;
        }
        page.paragraph("## A leapfrog step");
        page.table(
                List.of("bodies", "Apsis, ns", "REBOUND, ns"),
                results.stepCosts.stream()
                        .map(StepCost::bodies)
                        .distinct()
                        .map(n ->
                                List.of(String.valueOf(n), stepCost(n, StepCost.APSIS), stepCost(n, StepCost.REBOUND)))
                        .toList());
    }

    private String stepCost(int bodies, String engine) {
        return results.stepCosts.stream()
                .filter(cost -> cost.bodies() == bodies && cost.engine().equals(engine))
                .map(cost -> Cells.figure(cost.nanos()))
                .findFirst()
                .orElse("–");
    }

    private List<String> cases() {
        return results.orbits.stream()
                .filter(OrbitRow::isMeasured)
                .map(OrbitRow::caseId)
                .distinct()
                .toList();
    }
}

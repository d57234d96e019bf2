package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.report.Csv;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** Everything that was measured, in the order in which it was. */
final class Results {
    final List<OrbitRow> orbits = new ArrayList<>();
    final List<OrbitRow> peerOrbits = new ArrayList<>();
    final List<ForceRow> forces = new ArrayList<>();
    final List<RobustRow> robust = new ArrayList<>();
    final List<StepCost> stepCosts = new ArrayList<>();
    final List<EnergyOverTime.Row> energy = new ArrayList<>();
    final List<OrbitRow> solarSystem = new ArrayList<>();
    /** Settings whose energy is within its limit once per unit of time, as the limit was measured, and not between. */
    final List<String> swinging = new ArrayList<>();

    final List<String> contacts = new ArrayList<>();

    /** What must fail the command. */
    long bad() {
        return badOrbits() + robust.stream().filter(RobustRow::isBad).count();
    }

    private long badOrbits() {
        return Stream.concat(orbits.stream(), solarSystem.stream())
                .filter(row -> !row.isPeer() && Verdict.isBad(row.status()))
                .count();
    }

    /** As CSV, those that have rows. */
    List<String> tables() {
        List<String> tables = new ArrayList<>();
        if (!orbits.isEmpty()) {
            tables.add(Csv.file(
                    OrbitRow.HEADER,
                    Stream.concat(orbits.stream(), peerOrbits.stream()).map(OrbitRow::csv)));
        }
        if (!forces.isEmpty()) {
            tables.add(Csv.file(ForceRow.HEADER, forces.stream().map(ForceRow::csv)));
        }
        if (!robust.isEmpty()) {
            tables.add(Csv.file(RobustRow.HEADER, robust.stream().map(RobustRow::csv)));
        }
        return tables;
    }

    /** One line: how many rows, and how they fared. */
    String summary() {
        return "%d orbit rows: %d ok, %d cannot follow, %d outside tolerance, %d failed, %d skipped; "
                        .formatted(
                                orbits.size(),
                                count(Verdict.OK),
                                count(Verdict.CANNOT_FOLLOW),
                                count(Verdict.OUTSIDE),
                                count(Verdict.FAILED),
                                count(Verdict.SKIPPED))
                + "%d force rows; %d of %d hard inputs ok"
                        .formatted(
                                forces.size(),
                                robust.stream().filter(row -> !row.isBad()).count(),
                                robust.size());
    }

    private long count(String status) {
        return orbits.stream().filter(row -> row.status().startsWith(status)).count();
    }
}

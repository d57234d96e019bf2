package io.github.apsis.benchmarks.steering;

import io.github.apsis.benchmarks.report.Machine;
import io.github.apsis.benchmarks.report.Markdown;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;

/** The tables of a study for people; what they mean stands in the chapter. */
final class SteeringReport {
    private final List<SteeringRow> rows;
    private final List<ArrivalRow> arrivals;

    SteeringReport(List<SteeringRow> rows, List<ArrivalRow> arrivals) {
        this.rows = rows;
        this.arrivals = arrivals;
    }

    @Override
    public String toString() {
        var page = new Markdown();
        page.paragraph("Written by `apsis-bench steering` on %s. %s; %s."
                .formatted(LocalDate.now(ZoneOffset.UTC), Machine.jdk(), Machine.cpu()));
        page.table(
                List.of(
                        "scene",
                        "method",
                        "seeds",
                        "collisions / ship-minute",
                        "worst seed",
                        "hit, %",
                        "clearance",
                        "arrived, %",
                        "time ratio",
                        "speed",
                        "jerk, /s",
                        "CPU ms / tick / 1000"),
                rows.stream().map(SteeringRow::cells).toList());
        if (!arrivals.isEmpty()) {
            page.table(
                    List.of("arrival", "method", "settles, s", "overshoot", "final error"),
                    arrivals.stream().map(ArrivalRow::cells).toList());
        }
        return page.toString();
    }
}

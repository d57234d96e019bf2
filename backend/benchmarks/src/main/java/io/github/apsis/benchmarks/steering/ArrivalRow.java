package io.github.apsis.benchmarks.steering;

import io.github.apsis.benchmarks.report.Csv;
import java.util.List;
import java.util.Locale;

/** One line of {@code arrival.csv}: one instance of the scene whose ship comes to rest, with a method. */
record ArrivalRow(long instance, Contender method, double settle, double overshoot, double finalError) {
    static final String HEADER = "instance,method,settle_s,overshoot,final_error";

    static ArrivalRow of(long instance, Contender method, SteeringTally tally) {
        return new ArrivalRow(instance, method, tally.settle, tally.overshoot, tally.finalError);
    }

    String csv() {
        return Csv.line(cells().toArray(String[]::new));
    }

    List<String> cells() {
        return List.of(
                Long.toString(instance),
                method.label(),
                Double.isFinite(settle) ? String.format(Locale.ROOT, "%.3f", settle) : "never",
                String.format(Locale.ROOT, "%.3f", overshoot),
                String.format(Locale.ROOT, "%.5f", finalError));
    }
}

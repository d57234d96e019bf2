package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.report.Csv;

/** One line of {@code robust.csv}: a hard input, whether its check holds, and what happened, in a sentence. */
record RobustRow(String id, String status, String outcome) {
    static final String HEADER = "id,status,outcome";
    static final String OK = "ok";
    static final String FAILED = "failed";

    String csv() {
        return Csv.line(id, status, outcome);
    }

    boolean isBad() {
        return !status.equals(OK);
    }
}

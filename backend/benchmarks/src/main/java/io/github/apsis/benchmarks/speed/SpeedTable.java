package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.report.Csv;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * All rows of a folder. A run replaces the rows of its own JDK, scenes and number of threads and keeps the others: so one table
 * holds what two JDKs measured, and a single scene can be measured anew.
 */
final class SpeedTable {
    private final List<SpeedRow> rows;

    private SpeedTable(List<SpeedRow> rows) {
        this.rows = rows;
    }

    static SpeedTable empty() {
        return new SpeedTable(List.of());
    }

    /**
     * Reads a table; an empty one where there is no file.
     *
     * @throws IllegalArgumentException when it is the table of something else
     */
    static SpeedTable read(Path file) throws IOException {
        if (!Files.exists(file)) {
            return empty();
        }
        List<String> lines = Files.readAllLines(file);
        if (lines.isEmpty() || !lines.get(0).equals(SpeedRow.HEADER)) {
            throw new IllegalArgumentException(file + " is not a table of speeds: move it away first");
        }
        return new SpeedTable(lines.stream()
                .skip(1)
                .filter(line -> !line.isBlank())
                .map(SpeedRow::parse)
                .toList());
    }

    /** This table with what has been measured anew. */
    SpeedTable with(List<SpeedRow> fresh) {
        List<SpeedRow> all = new ArrayList<>(rows);
        all.removeIf(old -> fresh.stream()
                .anyMatch(row -> row.scene().equals(old.scene())
                        && row.threads() == old.threads()
                        && row.jdkFeature().equals(old.jdkFeature())));
        all.addAll(fresh);
        List<String> order = SpeedScenes.names();
        all.sort(Comparator.comparingInt((SpeedRow row) -> order.indexOf(row.scene()))
                .thenComparing(SpeedRow::jdkFeature)
                .thenComparing(SpeedRow::threads));
        return new SpeedTable(all);
    }

    List<SpeedRow> rows() {
        return rows;
    }

    String csv() {
        return Csv.file(SpeedRow.HEADER, rows.stream().map(SpeedRow::csv));
    }
}

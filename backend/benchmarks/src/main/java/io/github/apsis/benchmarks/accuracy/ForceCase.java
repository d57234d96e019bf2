package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.reference.Fraction;
import io.github.apsis.benchmarks.reference.Json;
import io.github.apsis.benchmarks.report.Csv;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import tools.jackson.databind.JsonNode;

/** Many masses at rest and the true acceleration of each, unsoftened. */
record ForceCase(String id, double g, double[] m, double[] x, double[] y, double[] ax, double[] ay, Path file) {
    ForceCase {
        if (m.length == 0) {
            throw new IllegalArgumentException("its table has no bodies");
        }
    }

    static ForceCase of(String id, JsonNode root, Path file) throws IOException {
        Path table = file.resolveSibling(Json.text(root, "csv"));
        if (!Files.isReadable(table)) {
            throw new IllegalArgumentException("its table " + table.getFileName() + " cannot be read");
        }
        List<String> lines = Files.readAllLines(table).stream()
                .filter(line -> !line.isBlank())
                .toList();
        return new ForceCase(
                id,
                Json.number(root, "G"),
                column(lines, "m"),
                column(lines, "x"),
                column(lines, "y"),
                column(lines, "ax"),
                column(lines, "ay"),
                file);
    }

    private static double[] column(List<String> lines, String name) {
        int index = lines.isEmpty() ? -1 : Csv.cells(lines.get(0)).indexOf(name);
        if (index < 0) {
            throw new IllegalArgumentException("its table has no column " + name);
        }
        double[] column = new double[lines.size() - 1];
        for (int i = 0; i < column.length; i++) {
            List<String> cells = Csv.cells(lines.get(i + 1));
            if (index >= cells.size()) {
                throw new IllegalArgumentException("its table has no " + name + " in line " + (i + 2));
            }
            column[i] = Fraction.parse(cells.get(index));
        }
        return column;
    }

    int count() {
        return m.length;
    }
}

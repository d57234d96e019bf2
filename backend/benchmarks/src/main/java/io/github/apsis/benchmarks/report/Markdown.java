package io.github.apsis.benchmarks.report;

import java.util.List;
import java.util.stream.Collectors;

/** A page in the making: paragraphs and tables. */
public final class Markdown {
    private final StringBuilder page = new StringBuilder();

    public void paragraph(String text) {
        page.append(text).append("\n\n");
    }

    public void table(List<String> head, List<List<String>> rows) {
        page.append(row(head));
        page.append(head.stream().map(cell -> "---").collect(Collectors.joining("|", "|", "|\n")));
        rows.forEach(cells -> page.append(row(cells)));
        page.append('\n');
    }

    private static String row(List<String> cells) {
        return cells.stream()
                .map(cell -> cell.replace("|", "\\|").replaceAll("\\R", " "))
                .collect(Collectors.joining(" | ", "| ", " |\n"));
    }

    @Override
    public String toString() {
        return page.toString().stripTrailing() + "\n";
    }
}

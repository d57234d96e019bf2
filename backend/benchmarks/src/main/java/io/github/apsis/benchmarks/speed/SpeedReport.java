package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.benchmarks.report.Machine;
import io.github.apsis.benchmarks.report.Markdown;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;

/** Writes the page about speed. All words about results are made from the figures. */
final class SpeedReport {
    private static final String OURS = "apsis";

    private final SpeedTable table;
    private final Markdown page = new Markdown();

    SpeedReport(SpeedTable table) {
        this.table = table;
    }

    /** The table is there already; adds the page and its plots. */
    void write(Path out, Consumer<String> progress) throws IOException {
        head();
        List<String> plots = drawn(out, progress);
        for (SpeedScene scene : SpeedScenes.all()) {
            List<SpeedRow> rows = table.rows().stream()
                    .filter(row -> row.scene().equals(scene.name()))
                    .toList();
            if (!rows.isEmpty()) {
                section(scene, rows, plots);
            }
        }
        beside(SpeedTable.read(out.resolve("beside.csv")));
        Files.writeString(out.resolve("README.md"), page.toString());
    }

    /** Features of the JDKs in the table, the oldest first. */
    static List<String> jdks(List<SpeedRow> rows) {
        return rows.stream().map(SpeedRow::jdkFeature).distinct().sorted().toList();
    }

    static boolean isOurs(String engine) {
        return engine.startsWith(OURS);
    }

    /** A machine without fonts draws nothing, and everything else is written all the same. */
    private List<String> drawn(Path out, Consumer<String> progress) throws IOException {
        try {
            return new SpeedPlots(table, out.resolve("plots")).draw();
        } catch (LinkageError | InternalError | IllegalStateException e) {
            progress.accept("no plots: " + e.getMessage());
            return List.of();
        }
    }

    // --- sections ---

    private void head() {
        String versions = table.rows().stream().map(SpeedRow::jdk).distinct().collect(Collectors.joining(" and "));
        page.paragraph("# Performance: what a tick costs, and its error");
        page.paragraph("Written by `apsis-bench speed` on %s. JDK %s; %s."
                .formatted(LocalDate.now(ZoneOffset.UTC), versions, Machine.cpu()));
        page.paragraph(
                """
                All figures are in [speed.csv](speed.csv): a row for each error of a scene, size and engine, with the time and \
                the allocation of the same run. To measure anew, once with each JDK, on one quiet core:""");
        page.paragraph(
                """
                ```sh
                taskset -c 0 java -jar backend/benchmarks/target/apsis-bench.jar speed --out docs/performance
                taskset -c 0 java -jar backend/benchmarks/target/apsis-bench.jar speed --short --scene s1-gas --out docs/performance
                ```""");
        page.paragraph(
                """
                A run replaces the rows of its own JDK, scenes and `--threads` and keeps the others. The engines of a scene run one after the other \
                in one JVM; ratios mean something within one run, the milliseconds of two days do not. In the tables below ratios \
                and errors are those of the first JDK.""");
        page.paragraph(
                """
                - `ms_per_step`: CPU time of the stepping thread, measured for batches of steps as a whole; the median of the batches. \
                It counts neither other programs nor the threads of compiler and collector. On several threads it is the time by the clock.
                - `p99_ms`: by the clock, each step by itself; 99 of 100 take no longer. Others on the machine stretch it.
                - `alloc_bytes_per_step`: bytes that the stepping thread allocates, in the second half of the measured steps: columns that \
                grow with the most contacts that a scene has had so far mostly have their length by then.
                - Before, something of the same kind warms the compiler up and is thrown away; the measured run then has the same \
                steps on every machine, so its error is the same too. What takes more than some minutes is stopped after fewer steps.""");
        page.paragraph(
                """
                dyn4j 6.0.0 is in double precision with 6 and 2 iterations: as it comes (continuous detection of all), and in its two \
                cheaper modes, `bullets-only` and `discrete`. JBox2D 2.2.1.1 is in single precision with 8 and 3. Sleep and friction are off. \
                They and the quadtree of JTS 1.20.0 are left out where a scene would take them minutes: of a gas beyond 20 000 \
                discs (in a short run 5000), of a pile beyond 5000 (1000), of the broad phase beyond 20 000 circles (5000).""");
        page.paragraph(
                """
                The kernels by themselves, with JMH:

                ```sh
                java -cp backend/benchmarks/target/apsis-bench.jar org.openjdk.jmh.Main -prof gc
                ```""");
    }

    private void section(SpeedScene scene, List<SpeedRow> rows, List<String> plots) {
        page.paragraph("## " + scene.name());
        page.paragraph(scene.description());
        List<String> jdks = jdks(rows);
        List<String> head = new ArrayList<>(List.of("bodies", "engine"));
        for (String jdk : jdks) {
            head.addAll(List.of("ms, JDK " + jdk, "p99", "bytes"));
        }
        head.add("times " + OURS);
        head.add("error");
        page.table(head, lines(rows, jdks));
        String growth = growth(rows, jdks);
        if (!growth.isEmpty()) {
            page.paragraph("From %d bodies on the cost grows as %s.".formatted(PowerLaw.FROM, growth));
        }
        String pictures = plots.stream()
                .filter(name -> name.startsWith(scene.name() + "-jdk"))
                .map(name -> "<img src=\"plots/%s\" width=\"49%%\" alt=\"%s\">"
                        .formatted(name, name.replace(".png", "").replace('-', ' ')))
                .collect(Collectors.joining("\n"));
        if (!pictures.isEmpty()) {
            page.paragraph(pictures);
        }
    }

    private static List<List<String>> lines(List<SpeedRow> rows, List<String> jdks) {
        Set<Integer> sizes = new LinkedHashSet<>();
        Set<String> engines = new LinkedHashSet<>();
        rows.forEach(row -> sizes.add(row.n()));
        rows.forEach(row -> engines.add(row.contender()));
        List<List<String>> lines = new ArrayList<>();
        for (int n : sizes) {
            for (String engine : engines) {
                List<SpeedRow> here = rows.stream()
                        .filter(row -> row.n() == n && row.contender().equals(engine))
                        .toList();
                if (!here.isEmpty()) {
                    lines.add(line(here, jdks, ours(rows, n)));
                }
            }
        }
        return lines;
    }

    private static List<SpeedRow> ours(List<SpeedRow> rows, int n) {
        return rows.stream()
                .filter(row -> row.n() == n && row.contender().equals(OURS))
                .toList();
    }

    /** The ratio is that of the first JDK in which both were measured. */
    private static List<String> line(List<SpeedRow> here, List<String> jdks, List<SpeedRow> ours) {
        List<String> cells = new ArrayList<>();
        cells.add(String.valueOf(here.get(0).n()));
        cells.add(here.get(0).contender());
        String ratio = "–";
        for (String jdk : jdks) {
            SpeedRow row = first(here, jdk);
            SpeedRow our = first(ours, jdk);
            cells.add(row == null ? "–" : digits(row.msPerStep()));
            cells.add(row == null ? "–" : digits(row.p99Ms()));
            cells.add(row == null ? "–" : Cells.plain(Math.rint(row.allocBytesPerStep())));
            if (row != null && our != null && ratio.equals("–")) {
                ratio = Cells.times(row.msPerStep() / our.msPerStep());
            }
        }
        cells.add(ratio);
        String jdk = here.get(0).jdkFeature();
        cells.add(here.stream()
                .filter(row -> row.jdkFeature().equals(jdk))
                .map(row -> row.errorKind() + " " + Cells.brief(row.error()))
                .collect(Collectors.joining(", ")));
        return cells;
    }

    private static @Nullable SpeedRow first(List<SpeedRow> rows, String jdk) {
        return rows.stream()
                .filter(row -> row.jdkFeature().equals(jdk))
                .findFirst()
                .orElse(null);
    }

    /** Three digits, however small, and no exponent. */
    private static String digits(double ms) {
        if (!(ms > 0) || ms >= 1) {
            return Cells.figure(ms);
        }
        int zeros = (int) -Math.ceil(Math.log10(ms)); // behind the point
        return String.format(Locale.ROOT, "%." + Math.max(3, zeros + 3) + "f", ms);
    }

    private static String growth(List<SpeedRow> rows, List<String> jdks) {
        List<String> parts = new ArrayList<>();
        for (String engine : rows.stream().map(SpeedRow::contender).distinct().toList()) {
            for (String jdk : jdks) {
                List<SpeedRow> of = rows.stream()
                        .filter(row -> row.jdkFeature().equals(jdk))
                        .toList();
                PowerLaw.exponent(SpeedPlots.points(of, engine))
                        .ifPresent(k -> parts.add(String.format(Locale.ROOT, "n^%.2f (%s, JDK %s)", k, engine, jdk)));
            }
        }
        return String.join(", ", parts);
    }

    /** What was measured beside by other programs, in a table of the same columns. */
    private void beside(SpeedTable others) {
        if (others.rows().isEmpty()) {
            return;
        }
        page.paragraph("## Measured beside");
        page.paragraph(
                """
                The same scenes in engines that do not run in a JVM, by programs of their own on the same core in the same hour; CPU time of \
                the process, the median of the steps. The figures are in [beside.csv](beside.csv).""");
        page.table(
                List.of("scene", "bodies", "engine", "ms", "error"),
                others.rows().stream()
                        .map(row -> List.of(
                                row.scene(),
                                String.valueOf(row.n()),
                                row.engine(),
                                digits(row.msPerStep()),
                                row.errorKind() + " " + Cells.brief(row.error())))
                        .toList());
    }
}

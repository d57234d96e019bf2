package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.report.Chart;
import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.Set;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** Cost against the number of bodies, one picture for each scene and JDK; each line with the exponent that fits it. */
final class SpeedPlots {
    private static final List<Color> COLORS =
            List.of(Chart.BLUE, Chart.GREEN, Chart.SKY, Chart.PURPLE, Chart.GREY, Chart.BLACK);
    private static final List<Color> PEER_COLORS = List.of(Chart.VERMILION, Chart.ORANGE, Chart.PURPLE, Chart.BLACK);
    private static final List<Marker> PEER_MARKS =
            List.of(SeriesMarkers.SQUARE, SeriesMarkers.DIAMOND, SeriesMarkers.TRIANGLE_UP, SeriesMarkers.CROSS);

    private final SpeedTable table;
    private final Path folder;
    private final List<String> written = new ArrayList<>();

    SpeedPlots(SpeedTable table, Path folder) {
        this.table = table;
        this.folder = folder;
    }

    /** Draws every scene that came in more than one size, and returns the names of the files. */
    List<String> draw() throws IOException {
        Files.createDirectories(folder);
        for (String scene : SpeedScenes.names()) {
            for (String jdk : SpeedReport.jdks(table.rows())) {
                List<SpeedRow> rows = table.rows().stream()
                        .filter(row ->
                                row.scene().equals(scene) && row.jdkFeature().equals(jdk))
                        .toList();
                if (rows.stream().mapToInt(SpeedRow::n).distinct().count() > 1) {
                    draw(scene, jdk, rows);
                }
            }
        }
        return written;
    }

    private void draw(String scene, String jdk, List<SpeedRow> rows) throws IOException {
        var chart = new Chart(scene + ": cost against the number of bodies, JDK " + jdk, "bodies", "ms per step");
        Set<String> engines = new LinkedHashSet<>();
        rows.forEach(row -> engines.add(row.contender()));
        int ours = 0;
        int peers = 0;
        for (String engine : engines) {
            List<double[]> points = points(rows, engine);
            if (SpeedReport.isOurs(engine)) {
                chart.line(name(engine, points), points, COLORS.get(ours++ % COLORS.size()));
            } else {
                int look = peers++ % PEER_COLORS.size();
                chart.peer(name(engine, points), points, PEER_COLORS.get(look), PEER_MARKS.get(look));
            }
        }
        String file = scene + "-jdk" + jdk + ".png";
        chart.write(folder.resolve(file));
        written.add(file);
    }

    private static String name(String engine, List<double[]> points) {
        OptionalDouble exponent = PowerLaw.exponent(points);
        return exponent.isPresent() ? String.format(Locale.ROOT, "%s, n^%.2f", engine, exponent.getAsDouble()) : engine;
    }

    /** n and ms; a size has a row for each of its errors, and one of them will do. */
    static List<double[]> points(List<SpeedRow> rows, String engine) {
        List<double[]> points = new ArrayList<>();
        Set<Integer> seen = new LinkedHashSet<>();
        for (SpeedRow row : rows) {
            if (row.contender().equals(engine) && seen.add(row.n())) {
                points.add(new double[] {row.n(), row.msPerStep()});
            }
        }
        return points;
    }
}

package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.discs.Contender;
import io.github.apsis.benchmarks.report.Chart;
import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** The pictures of the chapter: time per tick against error. Down and to the left is better. */
final class ContactPlots {
    private static final String CPU = "CPU time per tick, µs";
    private static final Map<Contender, Look> LOOKS = new EnumMap<>(Contender.class);

    private record Look(Color color, Marker marker) {}

    static {
        LOOKS.put(Contender.APSIS_TICK, new Look(Chart.BLUE, SeriesMarkers.CIRCLE));
        LOOKS.put(Contender.APSIS_EXACT, new Look(Chart.GREEN, SeriesMarkers.CIRCLE));
        LOOKS.put(Contender.DYN4J, new Look(Chart.VERMILION, SeriesMarkers.SQUARE));
        LOOKS.put(Contender.DYN4J_BULLETS_ONLY, new Look(Chart.VERMILION, SeriesMarkers.DIAMOND));
        LOOKS.put(Contender.DYN4J_DISCRETE, new Look(Chart.ORANGE, SeriesMarkers.TRIANGLE_UP));
        LOOKS.put(Contender.DYN4J_ANY_SPEED, new Look(Chart.VERMILION, SeriesMarkers.TRIANGLE_DOWN));
        LOOKS.put(Contender.JBOX2D, new Look(Chart.BLACK, SeriesMarkers.CROSS));
    }

    private final Comparison results;
    private final Path folder;
    private final List<String> written = new ArrayList<>();

    ContactPlots(Comparison results, Path folder) {
        this.results = results;
        this.folder = folder;
    }

    /** Draws all that there is anything to draw of, and returns the names of the files. */
    List<String> draw() throws IOException {
        Files.createDirectories(folder);
        for (String id : results.ticks.stream().map(TickRow::caseId).distinct().toList()) {
            ticks(id, "time of the bounce, error", "time", TickRow::timeError);
            ticks(id, "position error at t = 1, relative", "position", TickRow::positionError);
        }
        scenes("gas", "relative energy drift", "energy", row -> Math.abs(row.energyDrift()));
        scenes("gas", "deepest overlap ever, radii", "overlap", SceneRow::deepest);
        scenes("pile", "deepest overlap at the end, radii", "overlap", SceneRow::deepestEnd);
        return written;
    }

    private void ticks(String id, String y, String what, ToDoubleFunction<TickRow> error) throws IOException {
        var chart = new Chart(id + ": " + what + " error against time per tick, ticks of 1/50 to 1/1600", CPU, y);
        LOOKS.forEach((engine, look) -> add(
                chart,
                engine.label(),
                engine,
                results.ticks.stream()
                        .filter(row -> row.caseId().equals(id) && row.engine() == engine)
                        .map(row -> new double[] {row.micros(), error.applyAsDouble(row)})
                        .toList()));
        write(chart, "ticks-" + id + "-" + what);
    }

    /** A line for each engine, from few bodies to many; what stopped before its end is in the table alone. */
    private void scenes(String scene, String y, String what, ToDoubleFunction<SceneRow> error) throws IOException {
        var chart = new Chart(scene + ": " + what + " against time per tick, from few bodies to many", CPU, y);
        LOOKS.forEach((engine, look) -> add(
                chart,
                engine.label(),
                engine,
                results.scenes.stream()
                        .filter(row -> row.scene().equals(scene)
                                && row.engine() == engine
                                && row.note().isEmpty())
                        .map(row -> new double[] {row.micros(), error.applyAsDouble(row)})
                        .toList()));
        write(chart, scene + "-" + what);
    }

    private static void add(Chart chart, String name, Contender engine, List<double[]> points) {
        Look look = LOOKS.getOrDefault(engine, new Look(Chart.GREY, SeriesMarkers.CIRCLE));
        if (engine.isOurs()) {
            chart.line(name, points, look.color());
        } else {
            chart.peer(name, points, look.color(), look.marker());
        }
    }

    private void write(Chart chart, String name) throws IOException {
        if (!chart.isEmpty()) {
            chart.write(folder.resolve(name + ".png"));
            written.add(name + ".png");
        }
    }
}

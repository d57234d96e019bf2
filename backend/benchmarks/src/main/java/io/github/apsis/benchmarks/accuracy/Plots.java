package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.report.Chart;
import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import org.knowm.xchart.style.markers.Marker;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** The pictures of the report. Axes are logarithmic: a straight line down to the right is a method of constant order. */
final class Plots {
    private static final double WORST = 10; // beyond it a run has nothing to do with its case any more
    private static final Map<String, Color> OURS = new LinkedHashMap<>();
    private static final Map<String, Look> PEERS = new LinkedHashMap<>();

    private record Look(Color color, Marker marker) {}

    static {
        OURS.put("semi-implicit-euler", Chart.GREY);
        OURS.put("leapfrog", Chart.SKY);
        OURS.put("yoshida4", Chart.PURPLE);
        OURS.put("pefrl", Chart.ORANGE);
        OURS.put("symplectic8", Chart.GREEN);
        OURS.put("adaptive", Chart.BLUE);
        PEERS.put("rebound-leapfrog", new Look(Chart.BLACK, SeriesMarkers.CROSS));
        PEERS.put("rebound-leapfrog4", new Look(Chart.BLACK, SeriesMarkers.TRIANGLE_UP));
        PEERS.put("rebound-leapfrog8", new Look(Chart.BLACK, SeriesMarkers.SQUARE));
        PEERS.put("rebound-whfast-c17", new Look(Chart.GREY, SeriesMarkers.TRIANGLE_DOWN));
        PEERS.put("rebound-bs", new Look(Chart.VERMILION, SeriesMarkers.DIAMOND));
        PEERS.put("rebound-ias15", new Look(Chart.VERMILION, SeriesMarkers.SQUARE));
        PEERS.put("rebound-ias15-aarseth85", new Look(Chart.VERMILION, SeriesMarkers.TRIANGLE_UP));
    }

    private final Results results;
    private final Path folder;
    private final List<String> written = new ArrayList<>();

    Plots(Results results, Path folder) {
        this.results = results;
        this.folder = folder;
    }

    /** Draws all that there is anything to draw of, and returns the names of the files. */
    List<String> draw() throws IOException {
        Files.createDirectories(folder);
        for (String id : cases(results.orbits)) {
            speed(id, results.orbits, results.peerOrbits, "energy", OrbitRow::energyError);
            speed(id, results.orbits, results.peerOrbits, "position", OrbitRow::positionError);
        }
        for (String id :
                results.forces.stream().map(ForceRow::caseId).distinct().toList()) {
            force(id);
        }
        energyOverTime();
        return written;
    }

    private static List<String> cases(List<OrbitRow> rows) {
        return rows.stream()
                .filter(OrbitRow::isMeasured)
                .map(OrbitRow::caseId)
                .distinct()
                .toList();
    }

    private void speed(
            String id, List<OrbitRow> ours, List<OrbitRow> peers, String what, ToDoubleFunction<OrbitRow> error)
            throws IOException {
        var chart = new Chart(
                id + ": " + what + " error against speed",
                "CPU time per unit of simulated time, µs",
                what.equals("energy") ? "largest relative energy error" : "position error at the end, relative");
        OURS.forEach((method, color) -> chart.line(method, points(id, ours, method, error), color));
        PEERS.forEach((method, look) -> chart.peer(
                method.replace("rebound-", "REBOUND "), points(id, peers, method, error), look.color(), look.marker()));
        write(chart, "speed-" + id + "-" + what);
    }

    private static List<double[]> points(
            String id, List<OrbitRow> rows, String method, ToDoubleFunction<OrbitRow> error) {
        return rows.stream()
                .filter(row -> row.caseId().equals(id) && row.method().equals(method) && row.isMeasured())
                .filter(row -> !row.status().startsWith(Verdict.CANNOT_FOLLOW) && error.applyAsDouble(row) < WORST)
                .filter(row -> !isRoomOfAdaptive(row))
                .map(row -> new double[] {row.cpuMicrosPerUnit(), error.applyAsDouble(row)})
                .sorted((a, b) -> Double.compare(a[0], b[0]))
                .toList();
    }

    /** The adaptive method ticked as a room ticks it is in the tables; it would tear the line. */
    private static boolean isRoomOfAdaptive(OrbitRow row) {
        return row.method().equals(Method.ADAPTIVE.label()) && row.dt() < 2 * Ladder.ROOM;
    }

    private void force(String id) throws IOException {
        var chart = new Chart(id + ": force error against speed", "CPU time of one evaluation, ms", "relative error");
        chart.line("tree, rms", forcePoints(id, "tree", ForceRow::rms), Chart.BLUE);
        chart.line("tree, median body", forcePoints(id, "tree", ForceRow::median), Chart.SKY);
        chart.line("direct sum, rms", forcePoints(id, "direct", ForceRow::rms), Chart.GREEN);
        chart.peer(
                "REBOUND tree, rms",
                forcePoints(id, "rebound-tree", ForceRow::rms),
                Chart.VERMILION,
                SeriesMarkers.SQUARE);
        chart.peer(
                "REBOUND tree, median body",
                forcePoints(id, "rebound-tree", ForceRow::median),
                Chart.ORANGE,
                SeriesMarkers.DIAMOND);
        chart.peer(
                "REBOUND direct, rms",
                forcePoints(id, "rebound-basic", ForceRow::rms),
                Chart.BLACK,
                SeriesMarkers.CROSS);
        write(chart, id);
    }

    private List<double[]> forcePoints(String id, String solver, ToDoubleFunction<ForceRow> error) {
        return results.forces.stream()
                .filter(row -> row.caseId().equals(id) && row.solver().equals(solver))
                .map(row -> new double[] {row.millis(), error.applyAsDouble(row)})
                .sorted((a, b) -> Double.compare(a[0], b[0]))
                .toList();
    }

    private void energyOverTime() throws IOException {
        var chart = new Chart(
                "figure8: energy error over 10 000 periods",
                "simulated time (a period is 6.33)",
                "largest relative energy error so far");
        Map<String, List<EnergyOverTime.Row>> series = new LinkedHashMap<>();
        results.energy.forEach(row ->
                series.computeIfAbsent(row.series(), name -> new ArrayList<>()).add(row));
        series.forEach((name, rows) -> {
            List<double[]> points = rows.stream()
                    .map(row -> new double[] {row.time(), row.energyError()})
                    .toList();
            Color color = OURS.get(rows.get(0).method());
            if (color != null) {
                chart.curve(name, points, color);
            } else {
                boolean ias15 = name.contains("ias15");
                chart.peer(
                        name.replace("rebound-", "REBOUND "),
                        points,
                        ias15 ? Chart.VERMILION : Chart.BLACK,
                        SeriesMarkers.NONE);
            }
        });
        write(chart, "energy-over-time");
    }

    private void write(Chart chart, String name) throws IOException {
        if (!chart.isEmpty()) {
            chart.write(folder.resolve(name + ".png"));
            written.add(name + ".png");
        }
    }
}

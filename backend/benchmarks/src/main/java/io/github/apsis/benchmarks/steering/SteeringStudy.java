package io.github.apsis.benchmarks.steering;

import io.github.apsis.benchmarks.reference.CaseFolder;
import io.github.apsis.benchmarks.reference.Json;
import io.github.apsis.benchmarks.report.Csv;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;

/** Runs scenes with all methods, and writes what came out; pictures too: of the paths in the small circle, and of all. */
public final class SteeringStudy {
    private static final String ARRIVAL = "arrival";
    private static final String DRAWN = "circle50";
    private static final int ARRIVALS = 24;
    private static final int HEAD_ONS = 5;

    private final Options options;
    private final Consumer<String> progress;
    private final List<SteeringRow> rows = new ArrayList<>();
    private final List<ArrivalRow> arrivals = new ArrayList<>();

    /**
     * What to run.
     *
     * @param scenes names of scenes, or one folder of instances; empty for all that are public
     * @param seeds of the scenes that have any; empty for the program's own choice
     * @param method the name of one; null for all
     */
    public record Options(List<String> scenes, List<Long> seeds, @Nullable String method) {
        public Options {
            scenes = List.copyOf(scenes);
            seeds = List.copyOf(seeds);
        }
    }

    /** What came out: the table as CSV, and a line about ours. */
    public record Outcome(String table, String summary) {}

    /**
     * A study.
     *
     * @param progress is told each line as it comes
     */
    public SteeringStudy(Options options, Consumer<String> progress) {
        this.options = options;
        this.progress = progress;
    }

    /**
     * Runs everything.
     *
     * @param out where tables and page go; null to write nothing
     * @throws IllegalArgumentException when there is nothing to run
     */
    public Outcome run(@Nullable Path out) throws IOException {
        List<Contender> methods =
                options.method() == null ? List.of(Contender.values()) : List.of(Contender.named(options.method()));
        Map<String, List<SteeringScene>> scenes = scenes();
        if (scenes.isEmpty()) {
            throw new IllegalArgumentException("There are no scenes in that folder.");
        }
        for (var entry : scenes.entrySet()) {
            for (Contender method : methods) {
                run(entry.getKey(), entry.getValue(), method);
            }
        }
        String table = Csv.file(SteeringRow.HEADER, rows.stream().map(SteeringRow::csv));
        if (out != null) {
            Files.createDirectories(out);
            Files.writeString(out.resolve("steering.csv"), table);
            if (!arrivals.isEmpty()) {
                Files.writeString(
                        out.resolve("arrival.csv"),
                        Csv.file(ArrivalRow.HEADER, arrivals.stream().map(ArrivalRow::csv)));
            }
            drawPaths(scenes, methods, out);
            drawRatios(out);
            Files.writeString(out.resolve("table.md"), new SteeringReport(rows, arrivals).toString());
        }
        return new Outcome(table, summary());
    }

    private void drawRatios(Path out) throws IOException {
        var plot = new RatioPlot(rows);
        if (!plot.isEmpty()) {
            Path folder = Files.createDirectories(out.resolve("plots"));
            Files.writeString(folder.resolve("collisions-against-time.svg"), plot.svg());
        }
    }

    private static void drawPaths(Map<String, List<SteeringScene>> scenes, List<Contender> methods, Path out)
            throws IOException {
        for (Contender method : List.of(Contender.APSIS, Contender.GDX_PRIORITY)) {
            if (scenes.containsKey(DRAWN) && methods.contains(method)) {
                String svg = new PathPicture(scenes.get(DRAWN).get(0), method).svg();
                Path folder = Files.createDirectories(out.resolve("plots"));
                Files.writeString(folder.resolve("paths-" + DRAWN + "-" + method.label() + ".svg"), svg);
            }
        }
    }

    private void run(String name, List<SteeringScene> instances, Contender method) {
        var all = new SteeringTally();
        double worst = 0;
        for (SteeringScene instance : instances) {
            SteeringTally one = SteeringTally.of(instance, method);
            worst = Math.max(worst, one.collisionsPerMinute());
            all.add(one);
            if (one.isArrival) {
                arrivals.add(ArrivalRow.of(instance.seed(), method, one));
            }
        }
        var row = new SteeringRow(name, method, seedsOf(instances), all, worst);
        rows.add(row);
        progress.accept(row.csv());
    }

    private static String seedsOf(List<SteeringScene> instances) {
        long first = instances.get(0).seed();
        long last = instances.get(instances.size() - 1).seed();
        return last - first == instances.size() - 1
                ? first == last ? Long.toString(first) : first + "-" + last
                : String.join(
                        " ",
                        instances.stream()
                                .map(scene -> Long.toString(scene.seed()))
                                .toList());
    }

    // --- what to run ---

    private Map<String, List<SteeringScene>> scenes() throws IOException {
        if (options.scenes().size() == 1
                && Files.isDirectory(Path.of(options.scenes().get(0)))) {
            return read(Path.of(options.scenes().get(0)));
        }
        Map<String, List<SteeringScene>> scenes = new LinkedHashMap<>();
        for (String name : options.scenes().isEmpty() ? SteeringScenes.NAMES : options.scenes()) {
            scenes.put(
                    name,
                    seeds(name).stream()
                            .map(seed -> SteeringScenes.of(name, seed))
                            .toList());
        }
        return scenes;
    }

    private Map<String, List<SteeringScene>> read(Path folder) throws IOException {
        Map<String, List<SteeringScene>> scenes = new LinkedHashMap<>();
        for (Path file : CaseFolder.files(folder)) {
            JsonNode json = Json.read(file);
            if (!SceneFile.holdsScene(json)) {
                progress.accept(file.getFileName() + " is no scene");
                continue;
            }
            try {
                SteeringScene scene = SceneFile.of(json);
                scenes.computeIfAbsent(scene.name(), name -> new ArrayList<>()).add(scene);
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException(file.getFileName() + ": " + e.getMessage(), e);
            }
        }
        return scenes;
    }

    private List<Long> seeds(String name) {
        if (name.equals(ARRIVAL)) {
            return upTo(0, ARRIVALS - 1);
        }
        if (name.equals("headon")) {
            return upTo(0, HEAD_ONS - 1);
        }
        if (!options.seeds().isEmpty()) {
            return options.seeds();
        }
        boolean crowd = name.startsWith("circle") || name.equals("streams");
        return upTo(1, name.startsWith("wander") ? 1 : crowd ? 3 : 10);
    }

    private static List<Long> upTo(long first, long last) {
        List<Long> seeds = new ArrayList<>();
        for (long seed = first; seed <= last; seed++) {
            seeds.add(seed);
        }
        return seeds;
    }

    private String summary() {
        long ours = rows.stream().filter(row -> row.method() == Contender.APSIS).count();
        long clean = rows.stream()
                .filter(row -> row.method() == Contender.APSIS && row.tally().events == 0)
                .count();
        return "apsis: no collision in " + clean + " of " + ours + " scenes";
    }
}

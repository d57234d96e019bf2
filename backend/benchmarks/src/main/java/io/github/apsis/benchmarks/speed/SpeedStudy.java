package io.github.apsis.benchmarks.speed;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** Runs the scenes and writes what they cost. */
public final class SpeedStudy {
    private final Options options;
    private final Consumer<String> progress;

    /**
     * What to run.
     *
     * @param scenes their names; all where there are none
     * @param threads that step a world; with more than one only the scenes that can use them are run
     */
    public record Options(Length length, List<String> scenes, int threads) {}

    /** How long the run takes. */
    public enum Length {
        /** Some seconds; the figures mean nothing. */
        GLIMPSE,
        /** Less than five minutes for all scenes. */
        SHORT,
        /** Half an hour. */
        FULL
    }

    /**
     * A study.
     *
     * @param progress is told each step
     */
    public SpeedStudy(Options options, Consumer<String> progress) {
        this.options = options;
        this.progress = progress;
    }

    /** The names of all scenes. */
    public static List<String> scenes() {
        return SpeedScenes.names();
    }

    /**
     * Runs everything, and returns the table of this run as CSV.
     *
     * @param out where the table, the page and its plots go; null to write nothing
     * @throws IllegalArgumentException when there is no such scene, or the folder holds another table
     */
    public String run(@Nullable Path out) throws IOException {
        List<SpeedScene> scenes = SpeedScenes.named(options.scenes()).stream()
                .filter(scene -> options.threads() == 1 || scene.usesThreads())
                .toList();
        if (scenes.isEmpty()) {
            throw new IllegalArgumentException("None of these scenes can be stepped by several threads.");
        }
        SpeedTable before = out == null ? SpeedTable.empty() : SpeedTable.read(out.resolve("speed.csv"));
        List<SpeedRow> rows = new ArrayList<>();
        Bench bench = new Bench(options.length(), options.threads(), rows::add, progress);
        for (SpeedScene scene : scenes) {
            scene.run(bench);
            if (out != null) { // before what takes long, and what may not end
                Files.createDirectories(out);
                Files.writeString(out.resolve("speed.csv"), before.with(rows).csv());
            }
        }
        if (out != null) {
            new SpeedReport(before.with(rows)).write(out, progress);
        }
        return SpeedTable.empty().with(rows).csv();
    }
}

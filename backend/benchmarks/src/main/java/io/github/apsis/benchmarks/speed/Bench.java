package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.speed.SpeedStudy.Length;
import io.github.apsis.engine.WorldSpec;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Where scenes are measured: how long, on how many threads, and who is told of it. */
final class Bench {
    private final Length length;
    private final int threads;
    private final Consumer<SpeedRow> rows;
    private final Consumer<String> progress;

    Bench(Length length, int threads, Consumer<SpeedRow> rows, Consumer<String> progress) {
        this.length = length;
        this.threads = threads;
        this.rows = rows;
        this.progress = progress;
    }

    int threads() {
        return threads;
    }

    Length length() {
        return length;
    }

    /** One of three values. */
    <T> T choose(T glimpse, T brief, T full) {
        return switch (length) {
            case GLIMPSE -> glimpse;
            case SHORT -> brief;
            case FULL -> full;
        };
    }

    /** The spec of a world of ours, which these threads step. */
    WorldSpec spec(WorldSpec.Builder builder) {
        return builder.threads(threads).build();
    }

    /** Measures and reports; an engine that fails has no row, and says why. */
    void measure(String scene, String engine, int n, Trial trial, Supplier<? extends Course> courses) {
        attempt(scene, engine, n, () -> trial.run(courses, threads));
    }

    /** Measures what costs the same at every step, for so many milliseconds. */
    void measure(String scene, String engine, int n, int millis, Supplier<? extends Course> courses) {
        attempt(scene, engine, n, () -> {
            Course course = courses.get();
            return Trial.lasting(millis, course::step).run(course, threads);
        });
    }

    private void attempt(String scene, String engine, int n, Supplier<Measured> work) {
        progress.accept("%s, %s, %d".formatted(scene, engine, n));
        try {
            work.get().rows(scene, engine, n, threads).forEach(rows);
        } catch (IllegalArgumentException | IllegalStateException e) {
            progress.accept("%s, %s, %d: failed: %s".formatted(scene, engine, n, e.getMessage()));
        }
    }
}

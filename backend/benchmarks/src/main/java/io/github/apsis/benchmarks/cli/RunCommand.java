package io.github.apsis.benchmarks.cli;

import io.github.apsis.benchmarks.SceneRun;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.scenes.Scene;
import io.github.apsis.scenes.SceneCatalogue;
import java.io.PrintWriter;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code apsis-bench run SCENE}: ticks a scene without a clock and reports speed and error. */
@Command(
        name = "run",
        description = "Ticks a scene as fast as it goes, and reports speed, drift and state hash.",
        mixinStandardHelpOptions = true,
        footer = {
            "",
            "Before the measurement the same scene runs for up to 3 s to warm the compiler up;",
            "that world is thrown away. Time per tick and allocation count the measured ticks alone; the",
            "first, in which a new world asks for its memory, is told apart."
        })
final class RunCommand implements Callable<Integer> {
    private static final long PROGRESS_NANOS = 5_000_000_000L;

    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before the command runs
    private CommandSpec command;

    @Parameters(
            arity = "0..1",
            paramLabel = "SCENE",
            description = "Name of the scene; without it, the scenes are listed.")
    private @Nullable String sceneName;

    @Option(
            names = "--seconds",
            paramLabel = "S",
            defaultValue = "60",
            description =
                    "Simulated seconds of a room's clock, 150 ticks each; not wall time. Default: ${DEFAULT-VALUE}")
    private double seconds;

    @Option(names = "--bodies", paramLabel = "N", description = "Number of bodies, for scenes that scale.")
    private @Nullable Integer bodies;

    @Option(names = "--seed", paramLabel = "N", defaultValue = "1", description = "Default: ${DEFAULT-VALUE}")
    private long seed;

    @Option(
            names = "--threads",
            paramLabel = "N",
            defaultValue = "1",
            description =
                    "Threads that step the world; the state hash is the same for any number. Default: ${DEFAULT-VALUE}")
    private int threads;

    @Option(names = "--json", description = "Prints one JSON object instead of a table.")
    private boolean json;

    @Override
    public Integer call() {
        Scene scene = scene();
        long ticks = ticks();
        var progress = new Progress(ticks);
        SceneRun.Result result = new SceneRun(scene, seed, threads()).measure(ticks, progress::report);
        var report = new RunReport(scene.name(), seed, threads, result);
        PrintWriter out = command.commandLine().getOut();
        out.println(json ? report.json() : report.table());
        out.flush();
        return 0;
    }

    private Scene scene() {
        if (sceneName == null) {
            throw wrong("Which scene? " + ListCommand.scenes());
        }
        try {
            return found(sceneName)
                    .orElseThrow(() -> wrong("There is no scene " + sceneName + ". " + ListCommand.scenes()));
        } catch (IllegalArgumentException e) {
            throw wrong(e.getMessage());
        }
    }

    private Optional<Scene> found(String name) {
        return bodies == null ? SceneCatalogue.byName(name) : SceneCatalogue.byName(name, bodies);
    }

    private int threads() {
        if (threads < 1 || threads > Team.MOST) {
            throw wrong("--threads must be 1 to " + Team.MOST + ", was " + threads);
        }
        return threads;
    }

    private long ticks() {
        if (!(seconds > 0 && seconds <= 1e9)) {
            throw wrong("--seconds must be above 0 and at most 1e9, was " + seconds);
        }
        return Math.max(1, Math.round(seconds * SceneRun.TICKS_PER_SECOND));
    }

    private ParameterException wrong(@Nullable String message) {
        return new ParameterException(command.commandLine(), String.valueOf(message));
    }

    /** A line on the error stream every five seconds, so that a long run is not a silent one. */
    private final class Progress {
        private final long ticks;
        private long last = System.nanoTime();

        private Progress(long ticks) {
            this.ticks = ticks;
        }

        private void report(long done) {
            long now = System.nanoTime();
            if (now - last >= PROGRESS_NANOS && done < ticks) {
                last = now;
                PrintWriter err = command.commandLine().getErr();
                err.printf("%d of %d ticks, %d %%%n", done, ticks, 100 * done / ticks);
                err.flush();
            }
        }
    }
}

package io.github.apsis.benchmarks.cli;

import io.github.apsis.benchmarks.speed.SpeedStudy;
import io.github.apsis.benchmarks.speed.SpeedStudy.Length;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code apsis-bench speed}: what a tick costs against the number of bodies, beside other engines, with the error of the same run. */
@Command(
        name = "speed",
        description = "Measures time, allocation and error of a tick in scenes of many sizes, beside other engines.",
        mixinStandardHelpOptions = true,
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:everything was measured", "2:the command makes no sense"},
        footer = {
            "",
            "With --out, speed.csv goes there, a page and plots; rows of other JDKs and scenes in it stay.",
            "Without, the table goes to standard output. Progress goes to standard error.",
            "Pin it to one core to compare: taskset -c 0 java -jar apsis-bench.jar speed"
        })
final class SpeedCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before the command runs
    private CommandSpec command;

    @Option(names = "--short", description = "Fewer steps and smaller scenes of other engines: less than five minutes.")
    private boolean quick;

    @Option(names = "--glimpse", description = "A few steps of a few bodies, to see that it runs: seconds.")
    private boolean glimpse;

    @Option(names = "--scene", paramLabel = "S", description = "Only this scene; may be repeated.")
    private List<String> scenes = List.of();

    @Option(
            names = "--threads",
            paramLabel = "N",
            defaultValue = "1",
            description =
                    "Threads that step a world, in the scenes that can have more than one; only those are run with more."
                            + " Default: ${DEFAULT-VALUE}")
    private int threads = 1;

    @Option(names = "--out", paramLabel = "DIR", description = "Folder for everything that comes out.")
    private @Nullable Path out;

    @Override
    public Integer call() throws IOException {
        Length length = glimpse ? Length.GLIMPSE : quick ? Length.SHORT : Length.FULL;
        if (threads < 1) {
            throw new ParameterException(command.commandLine(), "--threads must be 1 or more, was " + threads);
        }
        var study = new SpeedStudy(new SpeedStudy.Options(length, scenes, threads), this::tell);
        String table = tableOf(study);
        PrintWriter to = command.commandLine().getOut();
        if (out == null) {
            to.print(table);
        } else {
            to.println("measured, see " + out.resolve("README.md"));
        }
        to.flush();
        return 0;
    }

    private String tableOf(SpeedStudy study) throws IOException {
        try {
            return study.run(out);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(command.commandLine(), String.valueOf(e.getMessage()));
        }
    }

    private void tell(String progress) {
        PrintWriter err = command.commandLine().getErr();
        err.println(progress);
        err.flush();
    }
}

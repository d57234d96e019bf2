package io.github.apsis.benchmarks.cli;

import io.github.apsis.benchmarks.accuracy.AccuracyStudy;
import io.github.apsis.benchmarks.accuracy.Ladder;
import io.github.apsis.benchmarks.accuracy.Ladder.Thoroughness;
import io.github.apsis.benchmarks.accuracy.Method;
import io.github.apsis.benchmarks.reference.Fraction;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code apsis-bench accuracy}: every reference case over all methods and steps, beside REBOUND. */
@Command(
        name = "accuracy",
        description =
                "Runs cases with known right answers over all methods and steps, and reports error against speed.",
        mixinStandardHelpOptions = true,
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:all is within tolerance",
            "1:a row is outside its tolerance or has failed",
            "2:the command makes no sense"
        },
        footer = {
            "",
            "With --out, CSVs, plots and README.md go there; without, the tables go to standard output.",
            "Progress goes to standard error. A full run takes some ten minutes."
        })
final class AccuracyCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before the command runs
    private CommandSpec command;

    @Option(
            names = "--cases",
            paramLabel = "DIR",
            description = "Folder of cases in the reference format; without it, the cases that come with the program.")
    private @Nullable Path cases;

    @Option(names = "--case", paramLabel = "ID", description = "Only this case; may be repeated.")
    private List<String> ids = List.of();

    @Option(
            names = "--method",
            paramLabel = "M",
            description =
                    "Only this method; may be repeated. semi-implicit-euler, leapfrog, yoshida4, pefrl, symplectic8, "
                            + "adaptive.")
    private List<String> methods = List.of();

    @Option(names = "--dt", paramLabel = "DT", description = "Only this step, for example 1/150.")
    private @Nullable String dt;

    @Option(
            names = "--tolerance",
            paramLabel = "TOL",
            description = "Only this tolerance of the adaptive method, for example 1e-12.")
    private @Nullable String tolerance;

    @Option(names = "--short", description = "A quick look: few settings, short runs, less than a minute.")
    private boolean quick;

    @Option(names = "--out", paramLabel = "DIR", description = "Folder for everything that comes out.")
    private @Nullable Path out;

    @Option(
            names = "--python",
            paramLabel = "PATH",
            defaultValue = "python3",
            description = "A Python that may have REBOUND. Default: ${DEFAULT-VALUE}")
    private String python = "python3";

    @Override
    public Integer call() throws IOException {
        if (cases != null && !Files.isDirectory(cases)) {
            throw wrong("--cases must be a folder, was " + cases);
        }
        var ladder = new Ladder(
                chosen(),
                positive("--dt", dt),
                positive("--tolerance", tolerance),
                quick ? Thoroughness.SHORT : Thoroughness.FULL);
        var study = new AccuracyStudy(new AccuracyStudy.Options(cases, ids, ladder, python), this::tell);
        AccuracyStudy.Outcome outcome = outcomeOf(study);
        print(outcome);
        return outcome.allWell() ? 0 : 1;
    }

    private AccuracyStudy.Outcome outcomeOf(AccuracyStudy study) throws IOException {
        try {
            return study.run(out);
        } catch (IllegalArgumentException e) {
            throw wrong(String.valueOf(e.getMessage()));
        }
    }

    private void print(AccuracyStudy.Outcome outcome) {
        PrintWriter to = command.commandLine().getOut();
        if (out == null) {
            outcome.tables().forEach(to::println);
        }
        to.println(outcome.summary());
        to.flush();
    }

    private List<Method> chosen() {
        try {
            return methods.isEmpty()
                    ? List.of(Method.values())
                    : methods.stream().map(Method::of).distinct().toList();
        } catch (IllegalArgumentException e) {
            throw wrong(String.valueOf(e.getMessage()));
        }
    }

    private @Nullable Double positive(String option, @Nullable String text) {
        if (text == null) {
            return null;
        }
        double value;
        try {
            value = Fraction.parse(text);
        } catch (IllegalArgumentException e) {
            throw wrong(option + " must be a number such as 1/150, was " + text);
        }
        if (!(value > 0) || Double.isInfinite(value)) {
            throw wrong(option + " must be positive and finite, was " + text);
        }
        return value;
    }

    private void tell(String progress) {
        PrintWriter err = command.commandLine().getErr();
        err.println(progress);
        err.flush();
    }

    private ParameterException wrong(String message) {
        return new ParameterException(command.commandLine(), message);
    }
}

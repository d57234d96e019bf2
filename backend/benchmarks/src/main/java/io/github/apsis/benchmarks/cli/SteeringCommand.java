package io.github.apsis.benchmarks.cli;

import io.github.apsis.benchmarks.steering.SteeringStudy;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code apsis-bench steering}: how well ships keep clear of others, and how fast they arrive. */
@Command(
        name = "steering",
        description = "Runs scenes full of ships with every way to steer, and reports collisions, delays and cost.",
        mixinStandardHelpOptions = true,
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:the scenes were run", "2:the command makes no sense"},
        footer = {
            "",
            "With --out, steering.csv goes there, arrival.csv and the tables of a page; without, steering.csv goes to",
            "standard output. Progress goes to standard error."
        })
final class SteeringCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before the command runs
    private CommandSpec command;

    @Option(
            names = "--scenes",
            paramLabel = "NAMES|DIR",
            split = ",",
            description =
                    "Scenes by name, or a folder of instances in the reference format; without it, all public ones.")
    private List<String> scenes = new ArrayList<>();

    @Option(names = "--seeds", paramLabel = "LIST", description = "For example 1-10 or 1,4,9; of scenes by name.")
    private @Nullable String seeds;

    @Option(names = "--method", paramLabel = "M", description = "One way to steer, for example apsis; without it, all.")
    private @Nullable String method;

    @Option(names = "--out", paramLabel = "DIR", description = "Folder for everything that comes out.")
    private @Nullable Path out;

    @Override
    public Integer call() throws IOException {
        SteeringStudy.Outcome outcome;
        try {
            outcome = new SteeringStudy(new SteeringStudy.Options(scenes, seedList(), method), this::tell).run(out);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(command.commandLine(), String.valueOf(e.getMessage()));
        }
        PrintWriter to = command.commandLine().getOut();
        if (out == null) {
            to.print(outcome.table());
        }
        to.println(outcome.summary());
        to.flush();
        return 0;
    }

    private List<Long> seedList() {
        List<Long> list = new ArrayList<>();
        if (seeds == null) {
            return list;
        }
        for (String part : seeds.split(",", -1)) {
            try {
                int dash = part.indexOf('-', 1);
                long first = Long.parseLong(dash < 0 ? part : part.substring(0, dash));
                long last = dash < 0 ? first : Long.parseLong(part.substring(dash + 1));
                for (long seed = first; seed <= last; seed++) {
                    list.add(seed);
                }
            } catch (NumberFormatException e) {
                throw new IllegalArgumentException("--seeds must look like 1-10 or 1,4,9, was " + seeds, e);
            }
        }
        return list;
    }

    private void tell(String progress) {
        PrintWriter err = command.commandLine().getErr();
        err.println(progress);
        err.flush();
    }
}

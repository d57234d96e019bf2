package io.github.apsis.benchmarks.cli;

import io.github.apsis.benchmarks.contacts.ContactStudy;
import io.github.apsis.benchmarks.contacts.ContactStudy.Length;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code apsis-bench contacts}: every contact case in both modes of contacts, and the same scenes in other engines. */
@Command(
        name = "contacts",
        description = "Runs cases whose contacts are known, tick by tick and exactly, and reports how far they stray.",
        mixinStandardHelpOptions = true,
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:all is within tolerance",
            "1:a row is outside its tolerance or has failed",
            "2:the command makes no sense"
        },
        footer = {
            "",
            "With --out, contacts.csv goes there, and a page; without, the table goes to standard output.",
            "The program's own cases are followed by the same scenes in dyn4j and JBox2D, with plots: ten minutes.",
            "Progress goes to standard error."
        })
final class ContactsCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before the command runs
    private CommandSpec command;

    @Option(
            names = "--cases",
            paramLabel = "DIR",
            description = "Folder of cases in the reference format; without it, the cases that come with the program.")
    private @Nullable Path cases;

    @Option(names = "--short", description = "Small scenes in the other engines: two minutes.")
    private boolean quick;

    @Option(
            names = "--engines",
            negatable = true,
            description = "Compare with other engines, or do not. Without it: with --out, and without --cases.")
    private @Nullable Boolean engines;

    @Option(names = "--out", paramLabel = "DIR", description = "Folder for everything that comes out.")
    private @Nullable Path out;

    @Override
    public Integer call() throws IOException {
        if (cases != null && !Files.isDirectory(cases)) {
            throw wrong("--cases must be a folder, was " + cases);
        }
        var study = new ContactStudy(new ContactStudy.Options(cases, length()), this::tell);
        ContactStudy.Outcome outcome = outcomeOf(study);
        PrintWriter to = command.commandLine().getOut();
        if (out == null) {
            to.println(outcome.table());
        }
        to.println(outcome.summary());
        to.flush();
        return outcome.allWell() ? 0 : 1;
    }

    private Length length() {
        boolean compares = engines == null ? cases == null : engines;
        return !compares ? Length.NONE : quick ? Length.SHORT : Length.FULL;
    }

    private ContactStudy.Outcome outcomeOf(ContactStudy study) throws IOException {
        try {
            return study.run(out);
        } catch (IllegalArgumentException e) {
            throw wrong(String.valueOf(e.getMessage()));
        }
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

package io.github.apsis.benchmarks.cli;

import io.github.apsis.benchmarks.contacts.ContactStudy;
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

    @Option(names = "--out", paramLabel = "DIR", description = "Folder for everything that comes out.")
    private @Nullable Path out;

    @Override
    public Integer call() throws IOException {
        if (cases != null && !Files.isDirectory(cases)) {
            throw wrong("--cases must be a folder, was " + cases);
        }
        var study = new ContactStudy(cases, this::tell);
        ContactStudy.Outcome outcome = outcomeOf(study);
        PrintWriter to = command.commandLine().getOut();
        if (out == null) {
            to.println(outcome.table());
        }
        to.println(outcome.summary());
        to.flush();
        return outcome.allWell() ? 0 : 1;
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

package io.github.apsis.benchmarks.cli;

import java.util.Objects;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;

/** The entry point of {@code apsis-bench}. */
@Command(
        name = "apsis-bench",
        description = "Measures Apsis: how fast its scenes tick, and how far they stray from what physics conserves.",
        mixinStandardHelpOptions = true,
        versionProvider = ApsisBench.Version.class,
        synopsisSubcommandLabel = "COMMAND",
        subcommands = {
            RunCommand.class,
            ListCommand.class,
            AccuracyCommand.class,
            ContactsCommand.class,
            SpeedCommand.class,
            SteeringCommand.class
        })
public final class ApsisBench {
    public static void main(String[] args) {
        System.exit(commandLine().execute(args));
    }

    static CommandLine commandLine() {
        return new CommandLine(new ApsisBench());
    }

    /** The version in the manifest of the jar, and the JDK that runs it. */
    static final class Version implements IVersionProvider {
        @Override
        public String[] getVersion() {
            String version = ApsisBench.class.getPackage().getImplementationVersion();
            return new String[] {"apsis-bench " + Objects.requireNonNullElse(version, "(not packaged)"), Jdk.name()};
        }
    }
}

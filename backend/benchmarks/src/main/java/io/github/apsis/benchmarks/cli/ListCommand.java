package io.github.apsis.benchmarks.cli;

import io.github.apsis.scenes.ScalableScene;
import io.github.apsis.scenes.Scene;
import io.github.apsis.scenes.SceneCatalogue;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code apsis-bench list}: every scene with its title. */
@Command(name = "list", description = "Lists the scenes.", mixinStandardHelpOptions = true)
final class ListCommand implements Runnable {
    @Spec
    @SuppressWarnings("NullAway.Init") // set by picocli before the command runs
    private CommandSpec command;

    @Override
    public void run() {
        command.commandLine().getOut().println(scenes());
    }

    /** One line for each scene; the star marks those that take any number of bodies. */
    static String scenes() {
        return SceneCatalogue.all().stream()
                .map(scene -> "  %-16s %s%s".formatted(scene.name(), scene.title(), mark(scene)))
                .collect(Collectors.joining("\n", "Scenes (* takes --bodies):\n", ""));
    }

    private static String mark(Scene scene) {
        return scene instanceof ScalableScene ? " *" : "";
    }
}

package io.github.apsis.benchmarks.accuracy;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;

/**
 * REBOUND (Rein and Liu 2012, A&amp;A 537, A128) by its Python module, run on the same files right after us, so that both are
 * measured on the same machine in the same minute.
 */
final class Rebound {
    private static final String SCRIPT = "rebound_peer.py";
    private static final int VERSION_SECONDS = 60;
    private static final int ROWS_SECONDS = 600;

    private final String python;
    private final Path script;
    private final String version;
    private final Ladder.Thoroughness thoroughness;

    private Rebound(String python, Path script, String version, Ladder.Thoroughness thoroughness) {
        this.python = python;
        this.script = script;
        this.version = version;
        this.thoroughness = thoroughness;
    }

    /** REBOUND as this Python has it; empty when it has not. */
    static Optional<Rebound> of(String python, Ladder.Thoroughness thoroughness) throws IOException {
        Path script = Files.createTempFile("apsis-", "-" + SCRIPT);
        script.toFile().deleteOnExit();
        try (InputStream in = Rebound.class.getResourceAsStream(SCRIPT)) {
            Files.copy(Objects.requireNonNull(in), script, StandardCopyOption.REPLACE_EXISTING);
        }
        try {
            List<String> said = run(List.of(python, script.toString(), "version"), VERSION_SECONDS);
            return said.isEmpty()
                    ? Optional.empty()
                    : Optional.of(new Rebound(python, script, said.get(said.size() - 1), thoroughness));
        } catch (IOException e) {
            return Optional.empty(); // no such Python
        }
    }

    String version() {
        return version;
    }

    /**
     * All settings of the peer on one case, until its last sample.
     *
     * @param horizon time over which speed is measured
     * @param step fixed steps are this times a power of two
     */
    List<OrbitRow> orbits(NBodyCase orbit, double horizon, double step) throws IOException {
        return rows(
                OrbitRow::parse,
                "nbody",
                orbit.file().toString(),
                Double.toString(orbit.end()),
                Double.toString(horizon),
                Double.toString(step));
    }

    List<ForceRow> forces(Path caseFile) throws IOException {
        return rows(ForceRow::parse, "force", caseFile.toString());
    }

    List<EnergyOverTime.Row> energyOverTime(Path caseFile, double end) throws IOException {
        return rows(EnergyOverTime.Row::parse, "energy", caseFile.toString(), Double.toString(end));
    }

    private <T> List<T> rows(Function<String, T> parse, String... arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of(python, script.toString()));
        command.addAll(List.of(arguments));
        if (thoroughness == Ladder.Thoroughness.SHORT) {
            command.add("--short");
        }
        List<T> rows = new ArrayList<>();
        for (String line : run(command, ROWS_SECONDS)) {
            try {
                rows.add(parse.apply(line));
            } catch (IllegalArgumentException e) {
                // REBOUND prints what it pleases; a line that is no row is none of ours.
            }
        }
        return rows;
    }

    /** The lines of standard output, as many as there were until the program ended or its time was up. */
    private static List<String> run(List<String> command, int seconds) throws IOException {
        Process process = new ProcessBuilder(command)
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
        process.onExit().orTimeout(seconds, TimeUnit.SECONDS).exceptionally(late -> process.destroyForcibly());
        List<String> lines = new ArrayList<>();
        try (BufferedReader out = process.inputReader(StandardCharsets.UTF_8)) {
            out.lines().forEach(lines::add);
        } catch (UncheckedIOException e) {
            // Ended in the middle of a line: what came before it counts.
        } finally {
            process.destroy();
        }
        return lines;
    }
}

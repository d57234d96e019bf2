package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.benchmarks.report.Csv;
import io.github.apsis.benchmarks.report.Machine;
import io.github.apsis.benchmarks.report.Markdown;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Writes the CSVs, the plots and the page that explains them. All words about results are made from the figures. */
final class AccuracyReport {
    private static final int MOST_COMPLAINTS = 20;
    private static final double AGREES = 1e-6; // AU

    private final Results results;
    private final AccuracyStudy.Options options;
    private final Optional<String> peer;
    private final Markdown page = new Markdown();

    AccuracyReport(Results results, AccuracyStudy.Options options, Optional<String> peer) {
        this.results = results;
        this.options = options;
        this.peer = peer;
    }

    void write(Path out, Consumer<String> progress) throws IOException {
        Files.createDirectories(out);
        file(out, "accuracy.csv", OrbitRow.HEADER, results.orbits.stream().map(OrbitRow::csv));
        file(out, "force.csv", ForceRow.HEADER, results.forces.stream().map(ForceRow::csv));
        file(out, "robust.csv", RobustRow.HEADER, results.robust.stream().map(RobustRow::csv));
        file(out, "rebound.csv", OrbitRow.HEADER, results.peerOrbits.stream().map(OrbitRow::csv));
        file(out, "step.csv", StepCost.HEADER, results.stepCosts.stream().map(StepCost::csv));
        if (!results.energy.isEmpty()) {
            file(
                    out,
                    "energy.csv",
                    EnergyOverTime.Row.HEADER,
                    results.energy.stream().map(EnergyOverTime.Row::csv));
        }
        if (!results.solarSystem.isEmpty()) {
            file(
                    out,
                    "solar-system.csv",
                    OrbitRow.HEADER,
                    results.solarSystem.stream().map(OrbitRow::csv));
        }
        Files.writeString(out.resolve("README.md"), page(plots(out, progress)));
    }

    private static void file(Path out, String name, String header, Stream<String> lines) throws IOException {
        Files.writeString(out.resolve(name), Csv.file(header, lines));
    }

    /** A machine without fonts draws nothing, and everything else is written all the same. */
    private List<String> plots(Path out, Consumer<String> progress) throws IOException {
        try {
            return new Plots(results, out.resolve("plots")).draw();
        } catch (LinkageError | InternalError | IllegalStateException e) {
            progress.accept("no plots: " + e.getMessage());
            return List.of();
        }
    }

    private String page(List<String> plots) {
        head();
        new OrbitSections(results, options.ladder().only(), page).write();
        forces();
        longRun(plots);
        solarSystem();
        robust();
        plots(plots);
        return page.toString();
    }

    // --- sections ---

    private void head() {
        page.paragraph("# Accuracy: speed against error");
        page.paragraph(
                "Written by `apsis-bench accuracy%s` on %s. %s; %s. %s"
                        .formatted(
                                options.isShort() ? " --short" : "",
                                LocalDate.now(ZoneOffset.UTC),
                                Machine.jdk(),
                                Machine.cpu(),
                                peer.map(version -> "Beside it REBOUND %s, run on each case right after ours."
                                                .formatted(version))
                                        .orElse(
                                                "Without REBOUND: it was not installed, so there is nothing to compare with.")));
        page.paragraph(
                """
                How measured: each setting runs twice over. One world is measured at up to 40 000 ticks spread over the run: \
                `L_error` is the largest until the end; so is `energy_error`, which of fixed steps is read once per unit of time, as \
                the limits were. `position_error` is the largest distance of a body from its true place at the end. Each is divided \
                by the scale that the case gives. The end is the last moment for which there is a limit, or the last sample. Other worlds are timed: \
                CPU time of the one thread, best of three after a warm-up, over up to 100 periods, divided by the simulated \
                time. All methods run in one JVM. REBOUND is timed by its process's CPU time in the same way, and measured in \
                extended precision: fixed steps once per unit of time too, the others at up to 1500 moments.""");
        page.paragraph("**" + results.summary() + ".**");
        page.paragraph(
                "Contacts have a chapter of their own: [time against error, beside dyn4j and JBox2D](contacts/README.md).");
        List<OrbitRow> bad = results.orbits.stream()
                .filter(row -> Verdict.isBad(row.status()) || row.status().startsWith(Verdict.SKIPPED))
                .toList();
        if (!bad.isEmpty()) {
            page.table(
                    List.of("not as it should be", "setting", "status"),
                    bad.stream()
                            .limit(MOST_COMPLAINTS)
                            .map(row -> List.of(row.caseId(), row.label(), row.status()))
                            .toList());
        }
        if (bad.size() > MOST_COMPLAINTS) {
            page.paragraph("… and %d more: see the column `status` of [accuracy.csv](accuracy.csv)."
                    .formatted(bad.size() - MOST_COMPLAINTS));
        }
        if (!results.swinging.isEmpty()) {
            page.paragraph(
                    "The energy of a symplectic method swings within a unit of time, and returns. Between the whole units at "
                            + "which it is read and limited it is above its limit for "
                            + String.join("; ", results.swinging) + ".");
        }
        if (!results.contacts.isEmpty()) {
            page.paragraph(
                    "Not run here, because they are about contacts: " + String.join(", ", results.contacts) + ".");
        }
    }

    private void forces() {
        if (results.forces.isEmpty()) {
            return;
        }
        page.paragraph("## Forces");
        page.paragraph(
                "One evaluation on one thread. Errors of single bodies are relative to their own acceleration, which is "
                        + "large where pulls cancel; rms is that of all errors against that of all accelerations.");
        page.table(
                List.of("case", "solver", "θ", "median", "99 %", "max", "rms", "net force", "ms"),
                results.forces.stream()
                        .map(row -> List.of(
                                row.caseId(),
                                row.solver(),
                                Double.isNaN(row.theta()) ? "" : Cells.plain(row.theta()),
                                Cells.brief(row.median()),
                                Cells.brief(row.p99()),
                                Cells.brief(row.max()),
                                Cells.brief(row.rms()),
                                Cells.brief(row.netForce()),
                                Cells.figure(row.millis())))
                        .toList());
    }

    private void longRun(List<String> plots) {
        if (results.energy.isEmpty()) {
            return;
        }
        page.paragraph("## Energy over 10 000 periods of the figure eight");
        if (plots.contains("energy-over-time.png")) {
            page.paragraph("![Energy error over time](plots/energy-over-time.png)");
        }
        List<String> series = results.energy.stream()
                .map(EnergyOverTime.Row::series)
                .distinct()
                .toList();
        page.table(
                List.of("method", "t = 63", "633", "6 330", "63 300"),
                series.stream()
                        .map(name -> Stream.concat(
                                        Stream.of(name),
                                        Stream.of(63, 633, 6330, 63_300).map(t -> energyAt(name, t)))
                                .toList())
                        .toList());
    }

    private String energyAt(String series, double time) {
        return results.energy.stream()
                .filter(row -> row.series().equals(series) && row.time() <= time * 1.01)
                .reduce((before, after) -> after)
                .map(row -> Cells.brief(row.energyError()))
                .orElse("–");
    }

    private void solarSystem() {
        if (results.solarSystem.isEmpty()) {
            return;
        }
        page.paragraph("## The solar system over 1000 years");
        page.paragraph(
                "The scene `solar-system`, Sun and eight planets; dt in days. No true state is known: \"difference\" is the "
                        + "largest distance of a planet, in AU, from our own tightest run (the adaptive method at 1e-16) after 1000 "
                        + "years, so it says how well methods agree and not which of them is right. Of REBOUND's settings those that "
                        + "differ by less than " + Cells.brief(AGREES)
                        + " AU; all are in [solar-system.csv](solar-system.csv).");
        page.table(
                List.of("method", "CPU per year, µs", "energy error", "L error", "difference, AU"),
                results.solarSystem.stream()
                        .filter(row -> row.isMeasured() && (!row.isPeer() || row.positionError() < AGREES))
                        .map(row -> List.of(
                                inDays(row),
                                Cells.figure(row.cpuMicrosPerUnit() * 365.25),
                                Cells.brief(row.energyError()),
                                Cells.brief(row.spinError()),
                                Cells.brief(row.positionError())))
                        .toList());
    }

    private static String inDays(OrbitRow row) {
        return row.method()
                + (Double.isNaN(row.tolerance()) ? "" : String.format(Locale.ROOT, " %.0e", row.tolerance()))
                + (Double.isNaN(row.dt()) ? "" : ", dt " + Cells.plain(Math.round(row.dt() * 1e3) * 1e-3));
    }

    private void robust() {
        if (results.robust.isEmpty()) {
            return;
        }
        page.paragraph("## Hard inputs");
        page.table(
                List.of("input", "status", "what happened"),
                results.robust.stream()
                        .map(row -> List.of(row.id(), row.status(), row.outcome()))
                        .toList());
    }

    private void plots(List<String> plots) {
        List<String> pictures = plots.stream()
                .filter(name -> !name.equals("energy-over-time.png"))
                .toList();
        if (!pictures.isEmpty()) {
            page.paragraph("## Plots");
            page.paragraph(pictures.stream()
                    .map(name -> "<img src=\"plots/%s\" width=\"49%%\" alt=\"%s\">"
                            .formatted(name, name.replace(".png", "").replace('-', ' ')))
                    .collect(Collectors.joining("\n")));
        }
    }
}

package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.benchmarks.discs.Contender;
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
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Writes the page about contacts, and the tables and plots of the other engines. All words about results are made from the figures. */
final class ContactReport {
    private static final int MOST_COMPLAINTS = 40;

    private final List<ContactRow> rows;
    private final Comparison others;
    private final String summary;
    private final Markdown page = new Markdown();

    ContactReport(List<ContactRow> rows, Comparison others, String summary) {
        this.rows = rows;
        this.others = others;
        this.summary = summary;
    }

    void write(Path out, Consumer<String> progress) throws IOException {
        Files.createDirectories(out);
        head();
        cases();
        if (!others.scenes.isEmpty()) {
            file(out, "ticks.csv", TickRow.HEADER, others.ticks.stream().map(TickRow::csv));
            file(out, "scenes.csv", SceneRow.HEADER, others.scenes.stream().map(SceneRow::csv));
            file(out, "bullets.csv", BulletRow.HEADER, others.bullets.stream().map(BulletRow::csv));
            file(out, "cradles.csv", CradleRow.HEADER, others.cradles.stream().map(CradleRow::csv));
            comparison();
            plots(drawn(out, progress));
        }
        Files.writeString(out.resolve("README.md"), page.toString());
    }

    private static void file(Path out, String name, String header, Stream<String> lines) throws IOException {
        Files.writeString(out.resolve(name), Csv.file(header, lines));
    }

    /** A machine without fonts draws nothing, and everything else is written all the same. */
    private List<String> drawn(Path out, Consumer<String> progress) throws IOException {
        try {
            return new ContactPlots(others, out.resolve("plots")).draw();
        } catch (LinkageError | InternalError | IllegalStateException e) {
            progress.accept("no plots: " + e.getMessage());
            return List.of();
        }
    }

    // --- sections ---

    private void head() {
        page.paragraph("# Contacts: time against error");
        page.paragraph("Written by `apsis-bench contacts` on %s. %s; %s. [All accuracy](../README.md)."
                .formatted(LocalDate.now(ZoneOffset.UTC), Machine.jdk(), Machine.cpu()));
        page.paragraph(
                """
                How measured: each case runs once in each mode, `contacts(e)` (tick) and `exactContacts(e)` (exact), to its last \
                sample, at the tick 1/n nearest to 1/150 on which all samples fall to the last bit; a sample that none meets is read in \
                a run of its own whose tick divides its time. Columns of [contacts.csv](contacts.csv):""");
        page.paragraph(
                """
                - `events_in_order`: bounces that came as the case lists them, from the first on, of how many. Bounces closer in time \
                than 1e-12 × amplification may come in either order.
                - `max_time_error`: largest \\|t − t_ref\\| of those, in units of time.
                - `max_position_error`: largest distance of a body from its true place at a sample, or of an apex from its true height, \
                divided by the case's length scale (of a planet drop: by the distance at its start).
                - `max_velocity_error`: largest difference of a velocity at a sample, divided by the velocity scale; where a case has no \
                samples, of a closing speed at a bounce (of a planet drop: divided by the fastest). Of outcomes: of a velocity after the contact, divided by the \
                fastest before.
                - `energy_change`: energy at a sample less that at the start, plus what the case's bounces take, Σ (1 − e²) c² μ / 2 (c \
                closing speed, μ reduced mass), divided by the largest kinetic energy of the run; where nothing may be lost, the largest \
                over all ticks. Of outcomes: kinetic energy less that of the outcome, divided by that at the start.
                - `momentum_error`: largest \\|p − p₀ − J\\| over all ticks, J by the world's books of walls and fields, divided by the \
                largest Σ m\\|v\\| of the run and what a uniform field gives in it, Σ m\\|g\\| T.""");
        page.paragraph(
                """
                `status` is by the rules of the format. Exact: order, times, places and velocities within 1e-12 × amplification (a \
                planet drop: 1e-10), momentum 1e-14, energy 1e-13 where e = 1, and nowhere a gain above that. Tick: momentum \
                1e-15 × √ticks and no gain; a pair head-on 1e-12 in velocity, off centre by \\|v\\| dt / (r₁ + r₂) of its direction, \
                and a bullet hits; apex n of a drop within (1 + n) \\|v\\| dt and none above the one before. Outcomes: 1e-9, or \
                where a set-up is its own mirror image (and not on one line) any outcome that is so too.""");
    }

    private void cases() {
        page.paragraph("**" + summary + ".**");
        List<ContactRow> odd = rows.stream()
                .filter(row -> !row.status().equals(ContactVerdict.OK))
                .toList();
        if (!odd.isEmpty()) {
            page.table(
                    List.of("not as it should be", "mode", "status"),
                    odd.stream()
                            .limit(MOST_COMPLAINTS)
                            .map(row -> List.of(row.caseId(), row.mode().label(), row.status()))
                            .toList());
        }
        page.paragraph("## Cases");
        page.table(
                List.of(
                        "case",
                        "mode",
                        "bounces in order",
                        "time",
                        "position",
                        "velocity",
                        "energy",
                        "momentum",
                        "status"),
                rows.stream().map(ContactReport::cells).toList());
    }

    private static List<String> cells(ContactRow row) {
        return List.of(
                row.caseId(),
                row.mode().label(),
                row.eventsInOrder(),
                Cells.brief(row.timeError()),
                Cells.brief(row.positionError()),
                Cells.brief(row.velocityError()),
                Cells.brief(row.energyChange()),
                Cells.brief(row.momentumError()),
                row.isBad() ? row.status().replaceFirst(":.*", "") : row.status());
    }

    private void comparison() {
        page.paragraph("## Beside other engines");
        page.paragraph(
                """
                The same scenes in one JVM, one after the other on one thread: discs of radius 2 and mass 1 without friction at 1/150 a \
                tick, sleep off. dyn4j 6.0.0 is in double precision, 6 and 2 iterations, restitution at any speed; "discrete" and \
                "bullets only" are its cheaper modes of continuous detection, and it lets nothing move by more than 2 lengths in a tick \
                unless told otherwise. JBox2D 2.2.1.1 is in single precision, 8 and 3 iterations; below a closing speed of 1 it does not \
                bounce, and 2 lengths in a tick are its limit. CPU time is of the one thread, for each tick by itself, after a \
                warm-up. Overlaps are in radii, looked at every ten ticks. A dash: not kept by right, or nothing to measure.""");
        page.table(
                List.of(
                        "scene",
                        "bodies",
                        "engine",
                        "ticks",
                        "CPU per tick, µs",
                        "99 %",
                        "energy",
                        "deepest overlap",
                        "at the end",
                        "mean at the end",
                        "rms speed at the end"),
                others.scenes.stream().map(ContactReport::cells).toList());
        page.paragraph(
                """
                The gas: elastic, at speed 60, a fifth of the area. The pile: e = 0.2 under a field of 100; the last fifth of its \
                ticks is timed. The chain: ten discs of mass 1 and 10⁶ in turn, pushed against a wall by a field of 100, which is right \
                without any overlap. Bullets: radius 1 at 5000, that is 33 lengths a tick, at a wall half a length thick, at a fixed disc \
                of radius 5 and at another bullet, from twenty places each; the speed that restitution 0.8 leaves is known.""");
        page.table(
                List.of("shot at", "engine", "went through", "largest error of the speed of the others"),
                others.bullets.stream()
                        .map(row -> List.of(
                                row.target(),
                                row.engine().label(),
                                row.through() + " of " + row.shots(),
                                Cells.brief(row.speedError())))
                        .toList());
        page.paragraph("Cradles: the last disc must leave at the speed of the first and the others rest.");
        List<Contender> engines =
                others.cradles.stream().map(CradleRow::engine).distinct().toList();
        page.table(
                Stream.concat(
                                Stream.of("largest error of a speed"),
                                engines.stream().map(Contender::label))
                        .toList(),
                others.cradles.stream()
                        .map(CradleRow::scene)
                        .distinct()
                        .map(this::cradle)
                        .toList());
        if (!others.failures.isEmpty()) {
            page.paragraph("What did not come to an end: " + String.join("; ", others.failures) + ".");
        }
    }

    private List<String> cradle(String scene) {
        return Stream.concat(
                        Stream.of(scene),
                        others.cradles.stream()
                                .filter(row -> row.scene().equals(scene))
                                .map(row -> Cells.brief(row.speedError())))
                .toList();
    }

    private static List<String> cells(SceneRow row) {
        return List.of(
                row.scene(),
                String.valueOf(row.bodies()),
                row.engine().label(),
                row.steps() + (row.note().isEmpty() ? "" : " (" + row.note() + ")"),
                Cells.figure(row.micros()),
                Cells.figure(row.p99Micros()),
                Cells.brief(row.energyDrift()),
                Cells.brief(row.deepest()),
                Cells.brief(row.deepestEnd()),
                Cells.brief(row.meanEnd()),
                Cells.brief(row.speedEnd()));
    }

    private void plots(List<String> plots) {
        page.paragraph("## Time per tick against error");
        page.paragraph(
                """
                Two cases of one bounce and the gas of 100 discs at ticks of 1/50 to 1/1600, up to t = 1; the time of a bounce is \
                where the straight paths before and after it meet, for every engine alike. The figures are in [ticks.csv](ticks.csv), \
                [scenes.csv](scenes.csv), [bullets.csv](bullets.csv) and [cradles.csv](cradles.csv).""");
        page.paragraph(plots.stream()
                .map(name -> "<img src=\"plots/%s\" width=\"49%%\" alt=\"%s\">"
                        .formatted(name, name.replace(".png", "").replace('-', ' ')))
                .collect(Collectors.joining("\n")));
    }

    /** One line: how many rows of each mode are as they should be. */
    static String summary(List<ContactRow> rows) {
        return Stream.of(ContactMode.values())
                .map(mode -> "%s: %d of %d ok"
                        .formatted(
                                mode.label(),
                                rows.stream()
                                        .filter(row -> row.mode() == mode
                                                && row.status().equals(ContactVerdict.OK))
                                        .count(),
                                rows.stream().filter(row -> row.mode() == mode).count()))
                .collect(Collectors.joining("; ", "contacts, ", ""));
    }
}

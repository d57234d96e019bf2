package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.benchmarks.report.Csv;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** Runs every contact case of a folder in both modes, and writes what came out. */
public final class ContactStudy {
    private static final long PATIENCE_SECONDS = 300; // of one case in one mode

    private final @Nullable Path cases;
    private final Consumer<String> progress;
    private final List<ContactRow> rows = new ArrayList<>();

    /**
     * A study.
     *
     * @param cases a folder in the reference format; null for the cases that come with the program
     * @param progress is told each step, and each file that cannot be used
     */
    public ContactStudy(@Nullable Path cases, Consumer<String> progress) {
        this.cases = cases;
        this.progress = progress;
    }

    /** What came out: the table as CSV; a line about it; and whether all is well. */
    public record Outcome(String table, String summary, boolean allWell) {}

    /**
     * Runs everything.
     *
     * @param out where the table goes; null to write nothing
     * @throws IllegalArgumentException when there is nothing to run
     */
    public Outcome run(@Nullable Path out) throws IOException {
        ContactFolder folder = cases == null ? ContactFolder.shipped() : ContactFolder.read(cases);
        if (folder.jobs().isEmpty()) {
            throw new IllegalArgumentException("There are no contact cases in that folder.");
        }
        if (folder.others() > 0) {
            progress.accept(folder.others() + " files of other kinds are not run here");
        }
        for (ContactFolder.Job job : folder.jobs()) {
            for (ContactMode mode : ContactMode.values()) {
                run(job, mode);
            }
        }
        String table = Csv.file(ContactRow.HEADER, rows.stream().map(ContactRow::csv));
        if (out != null) {
            Files.createDirectories(out);
            Files.writeString(out.resolve("contacts.csv"), table);
        }
        return new Outcome(table, summary(), rows.stream().noneMatch(ContactRow::isBad));
    }

    private void run(ContactFolder.Job job, ContactMode mode) {
        List<ContactRow> found;
        try {
            found = Patience.of(() -> job.rows().apply(mode), PATIENCE_SECONDS);
        } catch (
                IllegalStateException
                        e) { // the engine refuses, or stops, or has a bug: the other rows are worth having
            found = List.of(ContactRow.without(job.id(), mode, ContactVerdict.FAILED + e.getMessage()));
        }
        for (ContactRow row : found) {
            progress.accept("%s, %s: %s".formatted(row.caseId(), mode.label(), row.status()));
        }
        rows.addAll(found);
    }

    private String summary() {
        List<String> modes = new ArrayList<>();
        for (ContactMode mode : ContactMode.values()) {
            modes.add("%s: %d of %d ok"
                    .formatted(
                            mode.label(),
                            rows.stream()
                                    .filter(row ->
                                            row.mode() == mode && row.status().equals(ContactVerdict.OK))
                                    .count(),
                            rows.stream().filter(row -> row.mode() == mode).count()));
        }
        return "contacts, " + String.join("; ", modes);
    }
}

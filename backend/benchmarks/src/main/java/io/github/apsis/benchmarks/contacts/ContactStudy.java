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

    private final Options options;
    private final Consumer<String> progress;
    private final List<ContactRow> rows = new ArrayList<>();

    /**
     * What to run.
     *
     * @param cases a folder in the reference format; null for the cases that come with the program
     * @param length of the comparison with other engines
     */
    public record Options(@Nullable Path cases, Length length) {}

    /** How long the comparison with other engines takes. */
    public enum Length {
        /** Not at all. */
        NONE,
        /** Two minutes. */
        SHORT,
        /** Ten. */
        FULL
    }

    /**
     * A study.
     *
     * @param progress is told each step, and each file that cannot be used
     */
    public ContactStudy(Options options, Consumer<String> progress) {
        this.options = options;
        this.progress = progress;
    }

    /** What came out: the table as CSV; a line about it; and whether all is well. */
    public record Outcome(String table, String summary, boolean allWell) {}

    /**
     * Runs everything.
     *
     * @param out where the table, the page and its plots go; null to write nothing, and to compare nothing
     * @throws IllegalArgumentException when there is nothing to run
     */
    public Outcome run(@Nullable Path out) throws IOException {
        Path cases = options.cases();
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
            Files.writeString(out.resolve("contacts.csv"), table); // before what takes long
            var others = new Comparison(progress);
            if (options.length() != Length.NONE) {
                others.run(options.length(), ContactFolder.shipped().contacts());
            }
            new ContactReport(rows, others, ContactReport.summary(rows)).write(out, progress);
        }
        return new Outcome(table, ContactReport.summary(rows), rows.stream().noneMatch(ContactRow::isBad));
    }

    private void run(ContactFolder.Job job, ContactMode mode) {
        List<ContactRow> found;
        try {
            found = Patience.of(() -> job.rows().apply(mode), PATIENCE_SECONDS);
        } catch (IllegalStateException e) { // the engine refuses, or stops: the other rows are worth having
            found = List.of(ContactRow.without(job.id(), mode, ContactVerdict.FAILED + e.getMessage()));
        }
        for (ContactRow row : found) {
            progress.accept("%s, %s: %s".formatted(row.caseId(), mode.label(), row.status()));
        }
        rows.addAll(found);
    }
}

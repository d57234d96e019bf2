package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.benchmarks.accuracy.HardContacts;
import io.github.apsis.benchmarks.reference.CaseFolder;
import io.github.apsis.benchmarks.reference.Json;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import tools.jackson.databind.JsonNode;

/** The contact cases of a folder, by their format alone. A file that cannot be used is a row that has failed, and stops nothing. */
final class ContactFolder {
    /** Kinds of the format that are measured elsewhere. */
    private static final Set<String> ELSEWHERE = Set.of("nbody", "force", "tolerances");

    private final List<Job> jobs = new ArrayList<>();
    private final List<ContactCase> contacts = new ArrayList<>();
    private int others;

    /** What is to be run, in each mode. */
    record Job(String id, Function<ContactMode, List<ContactRow>> rows) {}

    static ContactFolder read(Path folder) throws IOException {
        var found = new ContactFolder();
        for (Path file : CaseFolder.files(folder)) {
            found.use(file);
        }
        return found;
    }

    /** Reads the cases that come with the program; the hard inputs are shared with the accuracy of orbits. */
    static ContactFolder shipped() throws IOException {
        ContactFolder found = read(CaseFolder.shipped(ContactFolder.class));
        found.use(CaseFolder.shipped(HardContacts.class).resolve("robust.json"));
        return found;
    }

    private void use(Path file) {
        String name = file.getFileName().toString().replaceFirst("\\.json$", "");
        try {
            JsonNode root = Json.read(file);
            if (!root.isObject()) {
                throw new IllegalArgumentException("it is not a JSON object");
            }
            add(root.hasNonNull("id") ? Json.text(root, "id") : name, root);
        } catch (IllegalArgumentException e) {
            refuse(name, ContactVerdict.FAILED + e.getMessage());
        } catch (IOException | UncheckedIOException e) {
            refuse(name, ContactVerdict.FAILED + "it cannot be read");
        }
    }

    private void add(String id, JsonNode root) {
        String kind = Json.text(root, "kind");
        switch (kind) {
            case "contact" -> add(ContactCase.of(id, root));
            case "planet-drop" -> add(ContactCase.planetDrop(id, root));
            case "outcomes" -> Json.field(root, "cases").forEach(setup -> addOutcomes(id, setup));
            case "robust" -> jobs.add(new Job(id, mode -> hardContacts(id, root, mode)));
            default -> {
                if (ELSEWHERE.contains(kind)) {
                    others++;
                } else {
                    refuse(id, ContactVerdict.SKIPPED + "the kind \"" + kind + "\" is not known here");
                }
            }
        }
    }

    private void add(ContactCase known) {
        contacts.add(known);
        jobs.add(new Job(known.id(), mode -> {
            var run = new ContactRun(known, mode);
            ContactErrors errors = run.errors();
            return List.of(ContactRow.of(known, mode, errors, ContactVerdict.of(known, mode, errors, run.dt())));
        }));
    }

    /** A set-up that cannot be read is a row that has failed; the others of its file are run all the same. */
    private void addOutcomes(String file, JsonNode setup) {
        String id = file + "/" + setup.path("id").asString("without id");
        try {
            for (OutcomeCase known : OutcomeCase.of(id, setup)) {
                jobs.add(new Job(known.id(), mode -> List.of(new OutcomeRun(known, mode).row())));
            }
        } catch (IllegalArgumentException e) {
            refuse(id, ContactVerdict.FAILED + e.getMessage());
        }
    }

    private static List<ContactRow> hardContacts(String file, JsonNode root, ContactMode mode) {
        return HardContacts.run(root, mode).stream()
                .map(result -> ContactRow.without(
                        file + "/" + result.id(),
                        mode,
                        result.isOk() ? ContactVerdict.OK : ContactVerdict.FAILED + result.outcome()))
                .toList();
    }

    private void refuse(String id, String status) {
        jobs.add(new Job(id, mode -> List.of(ContactRow.without(id, mode, status))));
    }

    List<Job> jobs() {
        return jobs;
    }

    /** Those of kind {@code contact} and {@code planet-drop}. */
    List<ContactCase> contacts() {
        return contacts;
    }

    /** How many files were of other kinds. */
    int others() {
        return others;
    }
}

package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.reference.CaseFolder;
import io.github.apsis.benchmarks.reference.Json;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;
import tools.jackson.databind.JsonNode;

/**
 * The cases of a folder, by their format alone: each {@code .json} says its {@code kind} and its {@code id}. A file that cannot
 * be used is a {@link Refusal} and stops nothing.
 */
final class ReferenceFolder {
    /** Kinds about contacts, which are measured elsewhere. */
    private static final Set<String> CONTACTS = Set.of("contact", "planet-drop", "outcomes");

    static final int DEFAULT_TICKS = 1500;

    private final List<NBodyCase> orbits = new ArrayList<>();
    private final List<ForceCase> forces = new ArrayList<>();
    private final List<RobustCase> robust = new ArrayList<>();
    private final List<RobustRow> brokenRobust = new ArrayList<>();
    private final Tolerances tolerances = new Tolerances();
    private final List<Refusal> refusals = new ArrayList<>();
    private final List<String> contacts = new ArrayList<>();

    /** A file that was not used, and why, as a status. */
    record Refusal(String id, String file, String status) {}

    /**
     * Reads a folder.
     *
     * @param wanted ids to use; files with others are passed over
     */
    static ReferenceFolder read(Path folder, Predicate<String> wanted) throws IOException {
        var found = new ReferenceFolder();
        for (Path file : CaseFolder.files(folder)) {
            found.use(file, wanted);
        }
        return found;
    }

    /** Reads the cases that come with the program. */
    static ReferenceFolder shipped(Predicate<String> wanted) throws IOException {
        return read(CaseFolder.shipped(ReferenceFolder.class), wanted);
    }

    private void use(Path file, Predicate<String> wanted) {
        String name = file.getFileName().toString().replaceFirst("\\.json$", "");
        try {
            JsonNode root = Json.read(file);
            if (!root.isObject()) {
                throw new IllegalArgumentException("it is not a JSON object");
            }
            add(root.hasNonNull("id") ? Json.text(root, "id") : name, root, file, wanted);
        } catch (IllegalArgumentException e) {
            refuse(name, file, wanted, Verdict.FAILED + e.getMessage());
        } catch (IOException | UncheckedIOException e) {
            refuse(name, file, wanted, Verdict.FAILED + "it cannot be read");
        }
    }

    private void add(String id, JsonNode root, Path file, Predicate<String> wanted) throws IOException {
        String kind = Json.text(root, "kind");
        if (kind.equals("tolerances")) {
            tolerances.read(root);
        } else if (kind.equals("robust")) {
            useRobust(root, one -> wanted.test(id) || wanted.test(one));
        } else if (!wanted.test(id)) {
            return;
        } else if (kind.equals("nbody")) {
            orbits.add(NBodyCase.of(id, root, file));
        } else if (kind.equals("force")) {
            forces.add(ForceCase.of(id, root, file));
        } else if (CONTACTS.contains(kind)) {
            contacts.add(id);
        } else {
            refuse(id, file, wanted, Verdict.SKIPPED + "the kind \"" + kind + "\" is not known here");
        }
    }

    /** A case that cannot be read is a row that has failed; the others of its file are run all the same. */
    private void useRobust(JsonNode root, Predicate<String> wanted) {
        int ticks = (int) Json.number(root, "default_ticks", DEFAULT_TICKS);
        for (JsonNode one : Json.field(root, "cases")) {
            String id = one.path("id").asString("without id");
            if (wanted.test(id)) {
                try {
                    robust.add(RobustCase.of(one, ticks));
                } catch (IllegalArgumentException e) {
                    brokenRobust.add(new RobustRow(id, RobustRow.FAILED, String.valueOf(e.getMessage())));
                }
            }
        }
    }

    private void refuse(String id, Path file, Predicate<String> wanted, String status) {
        if (wanted.test(id)) {
            refusals.add(new Refusal(id, file.getFileName().toString(), status));
        }
    }

    List<NBodyCase> orbits() {
        return orbits;
    }

    List<ForceCase> forces() {
        return forces;
    }

    List<RobustCase> robust() {
        return robust;
    }

    /** Hard inputs that could not be read. */
    List<RobustRow> brokenRobust() {
        return brokenRobust;
    }

    Tolerances tolerances() {
        return tolerances;
    }

    List<Refusal> refusals() {
        return refusals;
    }

    /** Ids of contact cases, which are not run here. */
    List<String> contacts() {
        return contacts;
    }
}

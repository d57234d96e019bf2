package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.benchmarks.reference.Json;
import java.util.ArrayList;
import java.util.List;
import tools.jackson.databind.JsonNode;

/** The hard inputs of a file that are about contacts, in any mode of contacts. */
public final class HardContacts {
    private HardContacts() {}

    /**
     * What came of one.
     *
     * @param isOk whether its check holds
     * @param outcome what happened, in a sentence
     */
    public record Result(String id, boolean isOk, String outcome) {}

    /** Runs them all; one that cannot be read is a result that is not ok. */
    public static List<Result> run(JsonNode root, ContactMode mode) {
        int ticks = (int) Json.number(root, "default_ticks", ReferenceFolder.DEFAULT_TICKS);
        List<Result> results = new ArrayList<>();
        for (JsonNode one : Json.field(root, "cases")) {
            try {
                RobustCase input = RobustCase.of(one, ticks);
                if (input.isAboutContacts()) {
                    RobustRow row = new RobustRun(input, mode, Integer.MAX_VALUE).run();
                    results.add(new Result(row.id(), !row.isBad(), row.outcome()));
                }
            } catch (IllegalArgumentException e) {
                results.add(new Result(one.path("id").asString("without id"), false, String.valueOf(e.getMessage())));
            }
        }
        return results;
    }
}

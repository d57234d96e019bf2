package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.reference.Json;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import tools.jackson.databind.JsonNode;

/** What a good implementation must meet, for each case, method and step. */
final class Tolerances {
    /** The tolerance parameter with which the adaptive method is judged. */
    static final double ADAPTIVE_DEFAULT = 1e-16;

    private static final double SAME_STEP = 1e-3;
    private final List<Limit> limits = new ArrayList<>();

    /**
     * One row of the file; infinite where it asks for nothing.
     *
     * @param dt of a fixed step; NaN for the adaptive method
     * @param until the moment up to which it holds
     */
    record Limit(String caseId, String method, double dt, double until, double energy, double spin, double position) {
        boolean holdsFor(String id, Setting setting) {
            return caseId.equals(id) && method.equals(setting.method().label()) && holdsForStep(setting);
        }

        private boolean holdsForStep(Setting setting) {
            return setting.method() == Method.ADAPTIVE
                    ? setting.tolerance() <= ADAPTIVE_DEFAULT
                    : Math.abs(setting.dt() / dt - 1) < SAME_STEP;
        }
    }

    void read(JsonNode root) {
        for (var entry : Json.field(root, "cases").properties()) {
            for (JsonNode row : entry.getValue()) {
                limits.add(new Limit(
                        entry.getKey(),
                        Json.text(row, "method"),
                        Json.number(row, "dt", Double.NaN),
                        Json.number(row, "T"),
                        Json.number(row, "energy", Double.POSITIVE_INFINITY),
                        Json.number(row, "L", Double.POSITIVE_INFINITY),
                        Json.number(row, "position", Double.POSITIVE_INFINITY)));
            }
        }
    }

    /** The last moment for which a case has a limit. */
    OptionalDouble lastOf(String id) {
        return limits.stream()
                .filter(limit -> limit.caseId().equals(id))
                .mapToDouble(Limit::until)
                .max();
    }

    List<Limit> of(String id, Setting setting) {
        return limits.stream().filter(limit -> limit.holdsFor(id, setting)).toList();
    }
}

package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.reference.Json;
import tools.jackson.databind.JsonNode;

/**
 * How much a small change of the start has grown by a moment: what no arithmetic of its precision can beat. Between the
 * moments of a case it grows exponentially; before the first from 1; after the last it stays.
 */
record Conditioning(double[] times, double[] amplification) {
    static final Conditioning NONE = new Conditioning(new double[0], new double[0]);

    Conditioning {
        if (times.length != amplification.length) {
            throw new IllegalArgumentException(
                    "its conditioning has " + times.length + " times and " + amplification.length + " amplifications");
        }
    }

    static Conditioning of(JsonNode root, double start) {
        if (!root.hasNonNull("conditioning")) {
            return NONE;
        }
        JsonNode node = root.get("conditioning");
        double[] times = Json.numbers(Json.field(node, "times"), "a time of its conditioning");
        for (int i = 0; i < times.length; i++) {
            times[i] -= start;
        }
        return new Conditioning(times, Json.numbers(Json.field(node, "amplification"), "an amplification"));
    }

    /** Never below 1. */
    double at(double time) {
        double before = 0;
        double grown = 1;
        for (int i = 0; i < times.length; i++) {
            double next = Math.max(1, amplification[i]);
            if (time <= times[i]) {
                double share = times[i] > before ? Math.max(0, (time - before) / (times[i] - before)) : 1;
                return grown * Math.pow(next / grown, share);
            }
            before = times[i];
            grown = next;
        }
        return grown;
    }
}

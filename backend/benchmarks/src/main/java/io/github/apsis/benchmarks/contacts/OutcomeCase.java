package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.reference.Json;
import io.github.apsis.engine.body.BodyDef;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import tools.jackson.databind.JsonNode;

/**
 * Discs that meet at one instant, and the velocities with which they leave.
 *
 * @param outcome vx, vy of each body; NaN where the case does not say
 */
record OutcomeCase(String id, double restitution, List<BodyDef> bodies, double[][] outcome) {
    OutcomeCase {
        if (!(restitution >= 0 && restitution <= 1)) {
            throw new IllegalArgumentException("its e must be 0 to 1, was " + restitution);
        }
        if (bodies.size() < 2) {
            throw new IllegalArgumentException("it has " + bodies.size() + " bodies, which cannot meet");
        }
        if (bodies.stream().allMatch(body -> body.vx() == 0 && body.vy() == 0)) {
            throw new IllegalArgumentException("nothing in it moves");
        }
    }

    /**
     * The outcomes of one set-up, one for each restitution.
     *
     * @param id of the file and of the set-up
     */
    static List<OutcomeCase> of(String id, JsonNode setup) {
        JsonNode list = Json.field(setup, "bodies");
        List<BodyDef> bodies = ContactCase.bodies(list);
        List<String> names = new ArrayList<>();
        list.forEach(body -> names.add(body.path("name").asString("")));
        List<OutcomeCase> all = new ArrayList<>();
        for (JsonNode outcome : Json.field(setup, "outcome")) {
            double e = Json.number(outcome, "e");
            all.add(new OutcomeCase(id + " e=" + plain(e), e, bodies, velocities(outcome, names)));
        }
        return all;
    }

    private static String plain(double e) {
        return e == Math.rint(e) ? String.valueOf((long) e) : String.valueOf(e);
    }

    /**
     * The velocities by the names of their fields: {@code vx} and {@code vy} list those of all bodies; {@code left_vx},
     * {@code target_speed} and {@code target_directions_deg} are of the bodies whose names, less their numbers, begin that word.
     */
    private static double[][] velocities(JsonNode outcome, List<String> names) {
        double[][] v = new double[names.size()][2];
        for (double[] one : v) {
            Arrays.fill(one, Double.NaN);
        }
        for (var field : outcome.properties()) {
            String name = field.getKey();
            if (name.equals("vx") || name.equals("vy")) {
                all(v, name, Json.numbers(field.getValue(), "its " + name));
            } else if (name.endsWith("_vx") || name.endsWith("_vy")) {
                for (int i : named(names, name.substring(0, name.length() - 3))) {
                    v[i][name.endsWith("x") ? 0 : 1] = Json.valueOf(field.getValue(), "its " + name);
                }
            } else if (name.endsWith("_speed")) {
                String who = name.substring(0, name.length() - 6);
                polar(v, outcome, who, named(names, who), Json.valueOf(field.getValue(), "its " + name));
            } else if (!name.equals("e") && !name.endsWith("_directions_deg")) {
                throw new IllegalArgumentException("an outcome says " + name + ", which is not known here");
            }
        }
        return v;
    }

    private static void all(double[][] v, String name, double[] values) {
        if (values.length != v.length) {
            throw new IllegalArgumentException(
                    "an outcome has " + values.length + " of " + name + " for " + v.length + " bodies");
        }
        for (int i = 0; i < values.length; i++) {
            v[i][name.equals("vx") ? 0 : 1] = values[i];
        }
    }

    private static void polar(double[][] v, JsonNode outcome, String who, List<Integer> indices, double speed) {
        double[] degrees = Json.numbers(Json.field(outcome, who + "_directions_deg"), "a direction");
        if (degrees.length != indices.size()) {
            throw new IllegalArgumentException(
                    "an outcome has " + degrees.length + " directions for " + indices.size() + " bodies named " + who);
        }
        for (int k = 0; k < degrees.length; k++) {
            v[indices.get(k)][0] = speed * Math.cos(Math.toRadians(degrees[k]));
            v[indices.get(k)][1] = speed * Math.sin(Math.toRadians(degrees[k]));
        }
    }

    private static List<Integer> named(List<String> names, String who) {
        List<Integer> found = new ArrayList<>();
        for (int i = 0; i < names.size(); i++) {
            String stem = names.get(i).replaceAll("\\d+$", "");
            if (!stem.isEmpty() && (who.startsWith(stem) || stem.startsWith(who))) {
                found.add(i);
            }
        }
        if (found.isEmpty()) {
            throw new IllegalArgumentException("an outcome is of " + who + ", and no body is named like that");
        }
        return found;
    }

    /** The largest speed at the start. */
    double fastest() {
        return bodies.stream()
                .mapToDouble(body -> Math.hypot(body.vx(), body.vy()))
                .max()
                .orElse(0);
    }

    /** The largest distance of two bodies at the start, length. */
    double extent() {
        double extent = 0;
        for (BodyDef a : bodies) {
            for (BodyDef b : bodies) {
                extent = Math.max(extent, Math.hypot(a.x() - b.x(), a.y() - b.y()));
            }
        }
        return extent;
    }
}

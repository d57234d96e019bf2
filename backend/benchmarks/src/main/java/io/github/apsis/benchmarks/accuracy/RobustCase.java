package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.reference.Json;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.StreamSupport;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;

/**
 * A hard numerical input, and what must come of it.
 *
 * @param bodies raw: some are not fit for a world, which is the point
 * @param dt of a tick; null where the case does not care
 * @param values to be tried one after the other
 * @param period after which an orbit closes; 0 where there is none
 * @param collisionTime at which two points meet; 0 where they do not
 * @param check what a machine can check
 */
record RobustCase(
        String id,
        double g,
        double @Nullable [] uniformG,
        List<RawBody> bodies,
        @Nullable Double dt,
        double[] values,
        double period,
        double collisionTime,
        int ticks,
        JsonNode check) {
    /** A body as the file has it, whatever its numbers. */
    record RawBody(double m, double r, double x, double y, double vx, double vy) {
        static RawBody of(JsonNode body) {
            return new RawBody(
                    Json.number(body, "m"),
                    Json.number(body, "r", 0),
                    Json.number(body, "x"),
                    Json.number(body, "y"),
                    Json.number(body, "vx", 0),
                    Json.number(body, "vy", 0));
        }

        RawBody shifted(double dx, double dy) {
            return new RawBody(m, r, x + dx, y + dy, vx, vy);
        }
    }

    /**
     * One case of a file.
     *
     * @param defaultTicks of the file, for a case that names no number of its own
     */
    static RobustCase of(JsonNode one, int defaultTicks) {
        return new RobustCase(
                Json.text(one, "id"),
                Json.number(one, "G", 0),
                one.hasNonNull("uniform_g") ? numbers(one.get("uniform_g")) : null,
                bodies(one),
                one.hasNonNull("dt") ? Json.number(one, "dt") : null,
                one.hasNonNull("values") ? numbers(one.get("values")) : new double[0],
                Json.number(one, "period", 0),
                Json.number(one, "collision_time", 0),
                (int) Json.number(one, "ticks", defaultTicks),
                Json.field(one, "check"));
    }

    private static List<RawBody> bodies(JsonNode one) {
        List<RawBody> bodies = new ArrayList<>();
        if (one.hasNonNull("bodies")) {
            one.get("bodies").forEach(body -> bodies.add(RawBody.of(body)));
        }
        JsonNode repeat = one.get("repeat");
        if (repeat != null) {
            RawBody body = RawBody.of(Json.field(repeat, "body"));
            int n = (int) Json.number(repeat, "n");
            for (int k = 0; k < n; k++) {
                bodies.add(body.shifted(k * Json.number(repeat, "dx", 0), k * Json.number(repeat, "dy", 0)));
            }
        }
        return bodies;
    }

    static double[] numbers(JsonNode list) {
        return StreamSupport.stream(list.spliterator(), false)
                .mapToDouble(value -> Json.valueOf(value, "a value"))
                .toArray();
    }

    /** Whether it is about discs that touch, and nothing else. */
    boolean isAboutContacts() {
        return g == 0 && dt == null && (!bodies.isEmpty() || id.equals(RobustScene.CROWD));
    }

    boolean asks(String name) {
        return check.hasNonNull(name);
    }

    double asked(String name) {
        return Json.number(check, name);
    }
}

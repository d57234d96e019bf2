package io.github.apsis.benchmarks.steering;

import io.github.apsis.benchmarks.reference.Json;
import io.github.apsis.benchmarks.steering.SteeringScene.Motion;
import io.github.apsis.benchmarks.steering.SteeringScene.Obstacles;
import java.io.IOException;
import java.nio.file.Path;
import tools.jackson.databind.JsonNode;

/** Reads an instance of a scene from a file in the reference format. */
final class SceneFile {
    private static final String[] SHIP_COLUMNS = {"x", "y", "vx", "vy", "gx", "gy"};

    private SceneFile() {}

    /** Whether the file holds a scene at all; checksums stand beside them. */
    static boolean holdsScene(JsonNode json) {
        return json.hasNonNull("scene") && json.hasNonNull("ships");
    }

    /**
     * The instance in a file.
     *
     * @throws IllegalArgumentException when something is missing or the checksum in it is another
     */
    static SteeringScene read(Path file) throws IOException {
        return of(Json.read(file));
    }

    static SteeringScene of(JsonNode json) {
        double[] wrap = Json.numbers(Json.field(json, "wrap"), "its wrap");
        JsonNode ships = Json.field(json, "ships");
        double[][] columns = new double[SHIP_COLUMNS.length][];
        for (int c = 0; c < columns.length; c++) {
            columns[c] = Json.numbers(Json.field(ships, SHIP_COLUMNS[c]), "a ship's " + SHIP_COLUMNS[c]);
        }
        var scene = new SteeringScene(
                Json.text(json, "scene"),
                (long) Json.number(json, "seed"),
                (int) Json.number(json, "maxTicks"),
                wrap[0],
                wrap[1],
                Json.number(json, "box"),
                Json.field(json, "wander").asBoolean(),
                Json.field(json, "dock").asBoolean(),
                columns,
                bodies(Json.field(json, "bodies")));
        String sum = Json.text(json, "checksum");
        if (!sum.equals(scene.checksum())) {
            throw new IllegalArgumentException("its checksum is " + scene.checksum() + " and not " + sum);
        }
        return scene;
    }

    private static Obstacles bodies(JsonNode json) {
        JsonNode kinds = Json.field(json, "kind");
        Motion[] motion = new Motion[kinds.size()];
        for (int k = 0; k < motion.length; k++) {
            motion[k] = Motion.of(kinds.get(k).asString(""));
        }
        return new Obstacles(
                motion,
                column(json, "x"),
                column(json, "y"),
                column(json, "vx"),
                column(json, "vy"),
                column(json, "r"),
                column(json, "mu"),
                column(json, "omega"));
    }

    private static double[] column(JsonNode json, String name) {
        return Json.numbers(Json.field(json, name), "a body's " + name);
    }
}

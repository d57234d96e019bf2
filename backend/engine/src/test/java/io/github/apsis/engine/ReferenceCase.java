package io.github.apsis.engine;

import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.collision.Boundary.HalfPlane;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A case with a known right answer, read from {@code src/test/resources/reference}. */
public final class ReferenceCase {
    private final JsonNode root;

    private ReferenceCase(JsonNode root) {
        this.root = root;
    }

    public static ReferenceCase of(String id) {
        return new ReferenceCase(json(id));
    }

    /** One of the hard inputs in {@code robust.json}. */
    static ReferenceCase robust(String id) {
        for (JsonNode hard : json("robust").get("cases")) {
            if (hard.get("id").asString().equals(id)) {
                return new ReferenceCase(hard);
            }
        }
        throw new IllegalArgumentException("robust.json has no case " + id);
    }

    /** The bodies of one of the cases in {@code simultaneous.json}. */
    public static List<BodyDef> simultaneous(String id) {
        for (JsonNode contacts : json("simultaneous").get("cases")) {
            if (contacts.get("id").asString().equals(id)) {
                return new ReferenceCase(contacts).bodies();
            }
        }
        throw new IllegalArgumentException("simultaneous.json has no case " + id);
    }

    static JsonNode json(String id) {
        try (InputStream in = ReferenceCase.class.getResourceAsStream("/reference/" + id + ".json")) {
            return JsonMapper.shared().readTree(in);
        } catch (java.io.IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    /** A number of the case, by its name. */
    public double number(String name) {
        return root.get(name).asDouble();
    }

    public JsonNode node(String name) {
        return root.get(name);
    }

    /** A world with the bodies of the case. */
    public World world(WorldSpec spec) {
        World world = new World(spec);
        for (BodyDef body : bodies()) {
            world.add(body);
        }
        return world;
    }

    /** The bodies of the case: listed, or one repeated along x. */
    List<BodyDef> bodies() {
        List<BodyDef> bodies = new ArrayList<>();
        for (JsonNode body : root.path("bodies")) {
            bodies.add(body(body));
        }
        JsonNode repeat = root.path("repeat");
        for (int k = 0; k < repeat.path("n").asInt(0); k++) {
            BodyDef body = body(repeat.get("body"));
            bodies.add(body.at(body.x() + k * repeat.path("dx").asDouble(0), body.y()));
        }
        return bodies;
    }

    /** The half-planes that a case calls walls. */
    public List<HalfPlane> walls() {
        List<HalfPlane> walls = new ArrayList<>();
        for (JsonNode wall : root.get("walls")) {
            walls.add(new HalfPlane(at(wall, "nx"), at(wall, "ny"), at(wall, "d")));
        }
        return walls;
    }

    private static BodyDef body(JsonNode body) {
        return BodyDef.planet(at(body, "x"), at(body, "y"), at(body, "m"), at(body, "r"))
                .moving(at(body, "vx"), at(body, "vy"));
    }

    private static double at(JsonNode body, String name) {
        return body.get(name).asDouble();
    }

    /** All samples, in order of time. */
    public List<Sample> samples() {
        List<Sample> samples = new ArrayList<>();
        for (JsonNode sample : root.get("samples")) {
            samples.add(new Sample(sample.get("t").asDouble(), sample.get("state")));
        }
        return samples;
    }

    /** A moment with its true state. */
    public record Sample(double time, JsonNode state) {
        /** Ticks of 1/150 until this moment. */
        public long tick() {
            return tick(WorldSpec.DEFAULT_DT);
        }

        /** Ticks of this length until this moment, which must fall on one. */
        public long tick(double dt) {
            long tick = Math.round(time / dt);
            if (Math.abs(tick * dt - time) > 1e-12 * time) {
                throw new IllegalArgumentException(time + " falls between two ticks of " + dt);
            }
            return tick;
        }

        /** The largest distance of a body from where it should be. */
        public double positionError(WorldSnapshot now) {
            double worst = 0;
            for (int i = 0; i < now.count(); i++) {
                JsonNode truth = state.get(i);
                worst = Math.max(
                        worst,
                        Math.hypot(
                                now.x(i) - truth.get(0).asDouble(),
                                now.y(i) - truth.get(1).asDouble()));
            }
            return worst;
        }

        /** The largest difference of a body's velocity from what it should be. */
        public double velocityError(WorldSnapshot now) {
            double worst = 0;
            for (int i = 0; i < now.count(); i++) {
                JsonNode truth = state.get(i);
                worst = Math.max(
                        worst,
                        Math.hypot(
                                now.vx(i) - truth.get(2).asDouble(),
                                now.vy(i) - truth.get(3).asDouble()));
            }
            return worst;
        }
    }

    /** Steps a world until the tick. */
    public static void run(World world, long tick) {
        while (world.tick() < tick) {
            world.step();
        }
    }
}

package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.benchmarks.discs.DiscScene;
import io.github.apsis.benchmarks.reference.Json;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.collision.Boundary.HalfPlane;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import java.util.ArrayList;
import java.util.List;
import tools.jackson.databind.JsonNode;

/**
 * Discs whose bounces and whose states at some moments are known.
 *
 * @param g of mutual gravity; 0 for none
 * @param fieldX of a uniform field, length / time²
 * @param walls half-planes, inside which the discs are
 * @param lengthScale what a distance is measured against
 * @param velocityScale what a difference of velocities is measured against
 * @param events in order of time; empty also where {@code knowsEvents} is false
 * @param knowsEvents whether the case lists its bounces: an empty list says that nothing touches
 * @param samples in order of time
 * @param apexHeights after each bounce, see {@link Apexes}; empty where the case names none
 * @param exact what counts as exact before amplification: a time, and a share of the scales
 */
record ContactCase(
        String id,
        double g,
        double fieldX,
        double fieldY,
        double restitution,
        double wallRestitution,
        List<HalfPlane> walls,
        List<BodyDef> bodies,
        double lengthScale,
        double velocityScale,
        List<ContactEvent> events,
        boolean knowsEvents,
        List<MotionSample> samples,
        Conditioning conditioning,
        double[] apexHeights,
        double exact) {
    private static final double EXACT = 1e-12;
    private static final double EXACT_UNDER_GRAVITY = 1e-10;
    private static final double UNIT = 1e-9; // normals closer to length 1 are taken as they are

    ContactCase {
        if (bodies.isEmpty()) {
            throw new IllegalArgumentException("it has no bodies");
        }
        requireShare("restitution", restitution);
        requireShare("wall_restitution", wallRestitution);
        if (!(lengthScale > 0) || !(velocityScale > 0)) {
            throw new IllegalArgumentException(
                    "its scales must be positive, were " + lengthScale + " and " + velocityScale);
        }
        requireOrder("samples", samples.stream().map(MotionSample::time).toList());
        requireOrder("events", events.stream().map(ContactEvent::time).toList());
        if (samples.isEmpty() && events.isEmpty()) {
            throw new IllegalArgumentException("it has neither samples nor events");
        }
    }

    private static void requireShare(String name, double e) {
        if (!(e >= 0 && e <= 1)) {
            throw new IllegalArgumentException("its " + name + " must be 0 to 1, was " + e);
        }
    }

    private static void requireOrder(String what, List<Double> times) {
        double before = 0;
        for (double time : times) {
            if (!(time >= before) || Double.isInfinite(time)) {
                throw new IllegalArgumentException("its " + what + " are not in order of time: " + time);
            }
            before = time;
        }
    }

    static ContactCase of(String id, JsonNode root) {
        if (Json.number(root, "friction", 0) != 0) {
            throw new IllegalArgumentException("it has friction, which no contact here has");
        }
        double start = Json.number(root, "t0", 0);
        List<BodyDef> bodies = bodies(Json.field(root, "bodies"));
        List<HalfPlane> walls = walls(root);
        double[] field =
                root.hasNonNull("uniform_g") ? Json.numbers(root.get("uniform_g"), "its uniform_g") : new double[2];
        if (field.length != 2) {
            throw new IllegalArgumentException("its uniform_g must be two numbers, was " + root.get("uniform_g"));
        }
        double restitution = Json.number(root, "restitution");
        return new ContactCase(
                id,
                root.path("mutual_gravity").asBoolean(false) ? Json.number(root, "G") : 0,
                field[0],
                field[1],
                restitution,
                Json.number(root, "wall_restitution", restitution),
                walls,
                bodies,
                Json.number(root, "length_scale", 1),
                Json.number(root, "velocity_scale", 1),
                root.hasNonNull("events") ? events(root.get("events"), start, bodies.size(), walls.size()) : List.of(),
                root.hasNonNull("events"),
                samples(root, start, bodies.size()),
                Conditioning.of(root, start),
                root.hasNonNull("apex_heights")
                        ? Json.numbers(Json.field(root.get("apex_heights"), "values"), "an apex height")
                        : new double[0],
                EXACT);
    }

    /** A ball that falls on a planet: its bounces name no bodies, and each how far the two part after it. */
    static ContactCase planetDrop(String id, JsonNode root) {
        List<BodyDef> bodies = bodies(Json.field(root, "bodies"));
        if (bodies.size() != 2) {
            throw new IllegalArgumentException("it has " + bodies.size() + " bodies and not a planet and a ball");
        }
        double start = Json.number(root, "t0", 0);
        List<ContactEvent> events = new ArrayList<>();
        List<Double> apexes = new ArrayList<>();
        for (JsonNode event : Json.field(root, "events")) {
            events.add(new ContactEvent(Json.number(event, "t") - start, 0, 1, Math.abs(Json.number(event, "vn"))));
            apexes.add(Json.number(event, "apex_after", Double.NaN));
        }
        double apart = Math.hypot(
                bodies.get(1).x() - bodies.get(0).x(),
                bodies.get(1).y() - bodies.get(0).y());
        double fastest =
                events.stream().mapToDouble(ContactEvent::closingSpeed).max().orElse(1);
        double restitution = Json.number(root, "restitution");
        return new ContactCase(
                id,
                Json.number(root, "G"),
                0,
                0,
                restitution,
                restitution,
                List.of(),
                bodies,
                Json.number(root, "length_scale", apart),
                Json.number(root, "velocity_scale", fastest),
                events,
                true,
                samples(root, start, bodies.size()),
                Conditioning.of(root, start),
                apexes.stream().mapToDouble(Double::doubleValue).toArray(),
                EXACT_UNDER_GRAVITY);
    }

    static List<BodyDef> bodies(JsonNode list) {
        List<BodyDef> bodies = new ArrayList<>();
        for (JsonNode body : list) {
            bodies.add(BodyDef.planet(
                            Json.number(body, "x"),
                            Json.number(body, "y"),
                            Json.number(body, "m"),
                            Json.number(body, "r", 0))
                    .moving(Json.number(body, "vx", 0), Json.number(body, "vy", 0)));
        }
        return bodies;
    }

    private static List<HalfPlane> walls(JsonNode root) {
        List<HalfPlane> walls = new ArrayList<>();
        for (JsonNode wall : root.path("walls")) {
            double nx = Json.number(wall, "nx");
            double ny = Json.number(wall, "ny");
            double d = Json.number(wall, "d");
            double length = Math.hypot(nx, ny);
            if (!(length > 0) || Double.isInfinite(length)) {
                throw new IllegalArgumentException(
                        "the normal of a wall must have a direction, was (" + nx + ", " + ny + ")");
            }
            walls.add(
                    Math.abs(length - 1) <= UNIT
                            ? new HalfPlane(nx, ny, d)
                            : new HalfPlane(nx / length, ny / length, d / length));
        }
        return walls;
    }

    private static List<ContactEvent> events(JsonNode list, double start, int bodies, int walls) {
        List<ContactEvent> events = new ArrayList<>();
        for (JsonNode event : list) {
            double time = Json.number(event, "t") - start;
            events.add(ContactEvent.of(
                    time,
                    partner(Json.field(event, "i"), bodies, walls),
                    partner(Json.field(event, "j"), bodies, walls),
                    Math.abs(Json.number(event, "vn", Double.NaN))));
        }
        return events;
    }

    /** A body by its index, or −1, −2, … for {@code "w0"}, {@code "w1"}, …. */
    private static int partner(JsonNode node, int bodies, int walls) {
        String name = node.asString("");
        boolean isWall = name.startsWith("w");
        int index;
        try {
            index = Integer.parseInt(isWall ? name.substring(1) : name);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException("an event is of no body or wall: " + node, e);
        }
        if (index < 0 || index >= (isWall ? walls : bodies)) {
            throw new IllegalArgumentException(
                    "an event is of a " + (isWall ? "wall" : "body") + " that is not there: " + node);
        }
        return isWall ? -1 - index : index;
    }

    private static List<MotionSample> samples(JsonNode root, double start, int bodies) {
        List<MotionSample> samples = new ArrayList<>();
        for (JsonNode sample : root.path("samples")) {
            double time = Json.number(sample, "t") - start;
            if (time > 0) { // a sample of the start itself proves nothing
                samples.add(MotionSample.of(time, Json.field(sample, "state"), bodies));
            }
        }
        return samples;
    }

    /** What the world of the case is made of; its bodies come with a {@link BounceLog}. */
    WorldSpec spec(ContactMode mode, double dt) {
        WorldSpec.Builder spec = WorldSpec.builder().dt(dt);
        if (g != 0) {
            spec.gravity(g);
            if (mode == ContactMode.EXACT) {
                spec.adaptive(1e-16);
            }
        }
        if (fieldX != 0 || fieldY != 0) {
            spec.law(new UniformField(fieldX, fieldY));
        }
        if (!walls.isEmpty()) {
            spec.halfPlanes(walls, wallRestitution);
        }
        return mode.on(spec, restitution).build();
    }

    /** The last moment of which something is known. */
    double end() {
        double lastSample =
                samples.isEmpty() ? 0 : samples.get(samples.size() - 1).time();
        return Math.max(
                lastSample, events.isEmpty() ? 0 : events.get(events.size() - 1).time());
    }

    /** Until when to look: where there is an apex after the last bounce, towards that. */
    double watched() {
        int last = events.size() - 1;
        boolean apexes = apexHeights.length > 0 && last > 0;
        return end()
                + (apexes
                        ? 0.25 * (events.get(last).time() - events.get(last - 1).time())
                        : 0);
    }

    /** What a uniform field gives to all bodies until the end, mass · length / time. */
    double fieldImpulse() {
        double mass = bodies.stream().mapToDouble(BodyDef::mass).sum();
        return mass * Math.hypot(fieldX, fieldY) * end();
    }

    /** The shortest time between two bounces; infinite where there are not two. */
    double shortestFlight() {
        double shortest = Double.POSITIVE_INFINITY;
        for (int k = 1; k < events.size(); k++) {
            shortest =
                    Math.min(shortest, events.get(k).time() - events.get(k - 1).time());
        }
        return shortest;
    }

    /** What a time or a relative error may be at a moment, for exact contacts. */
    double limit(double time) {
        return exact * conditioning.at(time);
    }

    /** Whether nothing may be lost: neither by the discs nor by the walls. */
    boolean isElastic() {
        return restitution == 1 && (walls.isEmpty() || wallRestitution == 1);
    }

    /** The energy that a bounce takes: (1 − e²) c² / (2 (1/m₁ + 1/m₂)). */
    double loss(ContactEvent event) {
        double e = event.second() < 0 ? wallRestitution : restitution;
        double m = bodies.get(event.first()).mass();
        double other = event.second() < 0
                ? Double.POSITIVE_INFINITY
                : bodies.get(event.second()).mass();
        double reduced = m == 0 || other == 0 ? 0 : 1 / (1 / m + 1 / other);
        return 0.5 * (1 - e * e) * reduced * event.closingSpeed() * event.closingSpeed();
    }

    /** The same for engines that know nothing of cases; the walls must be along the axes. */
    DiscScene scene(double dt) {
        List<DiscScene.Disc> discs = bodies.stream()
                .map(body ->
                        new DiscScene.Disc(body.x(), body.y(), body.vx(), body.vy(), body.radius(), body.mass(), false))
                .toList();
        double reach = bodies.stream()
                .mapToDouble(body -> Math.max(Math.abs(body.x()), Math.abs(body.y())) + body.radius())
                .max()
                .orElse(1);
        Aabb around = new Aabb(-reach, -reach, reach, reach);
        return new DiscScene(id, discs, walls, around, DiscScene.THICK, fieldX, fieldY, restitution, dt);
    }
}

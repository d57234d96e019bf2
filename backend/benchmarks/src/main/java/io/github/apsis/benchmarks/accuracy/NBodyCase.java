package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.reference.Json;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import tools.jackson.databind.JsonNode;

/**
 * Point masses under Newtonian gravity, with their true states at some moments.
 *
 * @param period characteristic time, for choosing steps; 0 where the case names none
 * @param samples in order of time, the first after the start
 * @param energy true energy
 * @param energyScale what an energy error is measured against
 * @param spin true angular momentum about the origin
 * @param spinScale what an angular momentum error is measured against
 * @param file where it was read, for those who read it again
 */
record NBodyCase(
        String id,
        double g,
        double softening,
        List<BodyDef> bodies,
        double period,
        List<Sample> samples,
        double lengthScale,
        double energy,
        double energyScale,
        double spin,
        double spinScale,
        Path file) {

    NBodyCase {
        if (bodies.isEmpty()) {
            throw new IllegalArgumentException("it has no bodies");
        }
        if (samples.isEmpty()) {
            throw new IllegalArgumentException("it has no samples");
        }
        double before = 0;
        for (Sample sample : samples) {
            if (!(sample.time() > before)) {
                throw new IllegalArgumentException("its samples are not in order of time: " + sample.time());
            }
            before = sample.time();
        }
    }

    static NBodyCase of(String id, JsonNode root, Path file) {
        JsonNode conserved = Json.field(root, "conserved");
        List<BodyDef> bodies = bodies(Json.field(root, "bodies"));
        double start = Json.number(root, "t0", 0);
        List<Sample> samples = new ArrayList<>();
        for (JsonNode sample : Json.field(root, "samples")) {
            double time = Json.number(sample, "t") - start;
            if (time > 0) { // a sample of the start itself proves nothing
                samples.add(sample(time, Json.field(sample, "state"), bodies.size()));
            }
        }
        return new NBodyCase(
                id,
                Json.number(root, "G"),
                Json.number(root, "softening", 0),
                bodies,
                Json.number(root, "period", 0),
                samples,
                Json.number(root, "length_scale"),
                Json.number(conserved, "E"),
                Json.number(root, "energy_scale"),
                Json.number(conserved, "L"),
                Json.number(root, "L_scale"),
                file);
    }

    private static List<BodyDef> bodies(JsonNode list) {
        List<BodyDef> bodies = new ArrayList<>();
        for (JsonNode body : list) {
            bodies.add(BodyDef.planet(
                            Json.number(body, "x"),
                            Json.number(body, "y"),
                            Json.number(body, "m"),
                            Json.number(body, "r", 0))
                    .moving(Json.number(body, "vx"), Json.number(body, "vy")));
        }
        return bodies;
    }

    private static Sample sample(double time, JsonNode state, int bodies) {
        if (state.size() != bodies) {
            throw new IllegalArgumentException(
                    "its sample at " + time + " has " + state.size() + " bodies and not " + bodies);
        }
        double[] x = new double[bodies];
        double[] y = new double[bodies];
        for (int i = 0; i < bodies; i++) {
            JsonNode body = state.get(i);
            if (body.size() < 2) {
                throw new IllegalArgumentException("its sample at " + time + " has no position of body " + i);
            }
            x[i] = Json.valueOf(body.get(0), "an x at " + time);
            y[i] = Json.valueOf(body.get(1), "a y at " + time);
        }
        return new Sample(time, x, y);
    }

    /** A world with the bodies of the case, at its start. */
    World world(Setting setting) {
        WorldSpec.Builder spec =
                WorldSpec.builder().integration(setting.method().integration());
        if (setting.method() == Method.ADAPTIVE) {
            spec.adaptive(setting.tolerance());
        }
        if (g != 0) {
            spec.gravity(g);
        }
        if (softening != 0) {
            spec.softening(softening);
        }
        World world = new World(spec.dt(setting.dt()).build());
        bodies.forEach(world::add);
        return world;
    }

    /** The last moment whose state is known. */
    double end() {
        return samples.get(samples.size() - 1).time();
    }

    /** The same case, known up to this moment only; up to its first sample at least. */
    NBodyCase until(double time) {
        List<Sample> kept =
                samples.stream().filter(sample -> sample.time() <= time).toList();
        return new NBodyCase(
                id,
                g,
                softening,
                bodies,
                period,
                kept.isEmpty() ? samples.subList(0, 1) : kept,
                lengthScale,
                energy,
                energyScale,
                spin,
                spinScale,
                file);
    }

    /** The last sample within so many periods: long enough to measure speed on; the end where there is no period. */
    double within(int periods) {
        return period > 0 ? until(period * periods * 1.001).end() : end();
    }
}

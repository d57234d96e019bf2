package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.scenes.Scene;
import io.github.apsis.scenes.SceneBody;
import io.github.apsis.scenes.SceneCatalogue;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * The solar system of the scenes over a thousand years. Nobody knows its true state then, so the tightest adaptive run stands in
 * for it: position errors are distances from that run, and say how well methods agree.
 */
final class SolarMillennium {
    static final String ID = "solar-system";
    private static final double YEAR = 365.25; // days, the time unit of the scene
    private static final double[] YEARS = {1, 10, 100, 1000};
    private static final double SCENE_TICK = 0.1;
    private static final double LENGTH = 1; // AU

    private SolarMillennium() {}

    /** The scene as a case, its samples from the tightest run; written to a file for the peer to read. */
    static NBodyCase write(Path folder) throws IOException {
        Scene scene = SceneCatalogue.byName(ID).orElseThrow();
        List<BodyDef> bodies = scene.bodies(0).stream().map(SceneBody::def).toList();
        double g = scene.spec(0).gravity();
        NBodyCase start =
                caseOf(g, bodies, List.of(new Sample(YEAR, new double[0], new double[0])), scene.world(0), folder);
        World world = start.world(Setting.adaptive(YEAR, Tolerances.ADAPTIVE_DEFAULT));
        List<Sample> samples = new ArrayList<>();
        for (double years : YEARS) {
            while (world.tick() < years) {
                world.step();
            }
            samples.add(sample(world.snapshot(), years * YEAR));
        }
        NBodyCase orbit = caseOf(g, bodies, samples, scene.world(0), folder.resolve(ID + ".json"));
        Files.writeString(orbit.file(), json(orbit));
        return orbit;
    }

    /** Tight and loose, and as a room runs it. */
    static List<Setting> settings() {
        return List.of(
                Setting.adaptive(YEAR, 1e-16),
                Setting.adaptive(YEAR, 1e-14),
                Setting.adaptive(YEAR, 1e-12),
                Setting.adaptive(YEAR, 1e-10),
                Setting.adaptive(SCENE_TICK, Tolerances.ADAPTIVE_DEFAULT),
                Setting.fixed(Method.LEAPFROG, SCENE_TICK),
                Setting.fixed(Method.PEFRL, 10 * SCENE_TICK),
                Setting.fixed(Method.SYMPLECTIC8, 50 * SCENE_TICK));
    }

    private static NBodyCase caseOf(double g, List<BodyDef> bodies, List<Sample> samples, World world, Path file) {
        Conserved start = world.conserved();
        double energy = start.energy().orElseThrow();
        return new NBodyCase(
                ID,
                g,
                0,
                bodies,
                YEAR,
                samples,
                LENGTH,
                energy,
                Math.abs(energy),
                start.angularMomentum(),
                Math.abs(start.angularMomentum()),
                file);
    }

    private static Sample sample(WorldSnapshot now, double time) {
        return new Sample(
                time,
                IntStream.range(0, now.count()).mapToDouble(now::x).toArray(),
                IntStream.range(0, now.count()).mapToDouble(now::y).toArray());
    }

    /** In the format of the reference folder, as much of it as a peer needs. */
    private static String json(NBodyCase orbit) {
        String bodies = orbit.bodies().stream()
                .map(body -> "{\"m\": %s, \"x\": %s, \"y\": %s, \"vx\": %s, \"vy\": %s}"
                        .formatted(body.mass(), body.x(), body.y(), body.vx(), body.vy()))
                .collect(Collectors.joining(",\n  "));
        String samples = orbit.samples().stream()
                .map(sample -> "{\"t\": %s, \"state\": [%s]}".formatted(sample.time(), states(sample)))
                .collect(Collectors.joining(",\n  "));
        return """
                {"id": "%s", "kind": "nbody", "G": %s, "t0": 0, "period": %s,
                 "length_scale": %s, "energy_scale": %s, "L_scale": %s, "conserved": {"E": %s, "L": %s},
                 "bodies": [%s],
                 "samples": [%s]}
                """
                .formatted(
                        orbit.id(),
                        orbit.g(),
                        orbit.period(),
                        orbit.lengthScale(),
                        orbit.energyScale(),
                        orbit.spinScale(),
                        orbit.energy(),
                        orbit.spin(),
                        bodies,
                        samples);
    }

    private static String states(Sample sample) {
        return IntStream.range(0, sample.x().length)
                .mapToObj(i -> "[" + sample.x()[i] + ", " + sample.y()[i] + "]")
                .collect(Collectors.joining(", "));
    }
}

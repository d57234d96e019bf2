package io.github.apsis.benchmarks.accuracy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Two equal masses on a circle of radius 1/2 about each other with period 2π: the state at any time is a sine and a cosine. */
final class TwoBodyCase {
    private TwoBodyCase() {}

    /** Writes the case into a folder; some of its numbers are strings, as the format allows. */
    static Path write(Path folder, String id) throws IOException {
        return Files.writeString(
                folder.resolve(id + ".json"),
                """
                {"id": "%s", "kind": "nbody", "G": "1.0", "t0": 0, "period": 6.283185307179586,
                 "bodies": [{"m": 0.5, "r": 0, "x": 0.5, "y": 0, "vx": 0, "vy": "0.5"},
                            {"m": 0.5, "r": 0, "x": -0.5, "y": 0, "vx": 0, "vy": -0.5}],
                 "samples": [%s, %s],
                 "conserved": {"E": -0.125, "L": 0.25, "px": 0, "py": 0},
                 "length_scale": 1, "energy_scale": 0.125, "L_scale": 0.25}
                """
                        .formatted(id, sample(1), sample(3)));
    }

    private static String sample(double t) {
        double x = 0.5 * Math.cos(t);
        double y = 0.5 * Math.sin(t);
        return "{\"t\": %s, \"state\": [[%s, %s, 0, 0], [\"%s\", %s, 0, 0]]}".formatted(t, x, y, -x, -y);
    }

    static NBodyCase read(Path folder) throws IOException {
        write(folder, "circle");
        return ReferenceFolder.read(folder, id -> id.equals("circle")).orbits().get(0);
    }
}

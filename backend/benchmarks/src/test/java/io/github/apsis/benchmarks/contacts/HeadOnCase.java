package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.reference.Json;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A disc of mass 1 at speed 1 that meets another of mass 1 at rest, e = 1/2: they touch after 1.5, at places that a reader can
 * check by hand, and leave at 1/4 and 3/4. The
 * wall is far away.
 */
final class HeadOnCase {
    private HeadOnCase() {}

    /** Writes the case into a folder; some of its numbers are strings, and all that can be left out is. */
    static Path write(Path folder, String id) throws IOException {
        return Files.writeString(
                folder.resolve(id + ".json"),
                """
                {"id": "%s", "kind": "contact", "restitution": "0.5",
                 "walls": [{"nx": 1, "ny": 0, "d": -9}],
                 "bodies": [{"m": 1, "r": 0.25, "x": 0, "y": 0, "vx": 1, "vy": 0},
                            {"m": 1, "r": 0.25, "x": "2", "y": 0}],
                 "events": [{"t": "1.5", "i": 1, "j": 0, "vn": -1}],
                 "samples": [{"t": 1, "state": [[1, 0, 1, 0], [2, 0, 0, 0]]},
                             {"t": 2.5, "state": [[1.75, 0, 0.25, 0], ["2.75", 0, 0.75, 0]]}]}
                """
                        .formatted(id));
    }

    static ContactCase read(Path folder) throws IOException {
        return ContactCase.of("bump", Json.read(write(folder, "bump")));
    }
}

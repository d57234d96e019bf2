package io.github.apsis.server.web;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** The examples of the treaty. */
final class Goldens {
    private Goldens() {}

    static String read(String name) throws IOException {
        return Files.readString(Path.of("../../docs/protocol/messages", name));
    }
}

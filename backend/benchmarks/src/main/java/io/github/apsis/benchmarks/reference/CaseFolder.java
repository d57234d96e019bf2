package io.github.apsis.benchmarks.reference;

import java.io.IOException;
import java.net.URI;
import java.net.URISyntaxException;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** Where the files of cases are: in a folder of the disk, or in the program itself. */
public final class CaseFolder {
    private CaseFolder() {}

    /** The {@code .json} files of a folder, by name. */
    public static List<Path> files(Path folder) throws IOException {
        try (Stream<Path> entries = Files.list(folder)) {
            return entries.filter(file -> file.toString().endsWith(".json"))
                    .sorted()
                    .toList();
        }
    }

    /** The folder {@code cases} that comes with the program beside a class; a copy where the program is a jar. */
    public static Path shipped(Class<?> beside) throws IOException {
        URI place = placeOf(beside);
        if (!"jar".equals(place.getScheme())) {
            return Path.of(place);
        }
        try (FileSystem jar = FileSystems.newFileSystem(place, Map.of())) {
            Path copy = Files.createTempDirectory("apsis-cases"); // a peer reads them too, and reads no jars
            copy.toFile().deleteOnExit();
            try (Stream<Path> entries = Files.list(jar.provider().getPath(place))) {
                for (Path entry : entries.toList()) {
                    Path file = copy.resolve(entry.getFileName().toString());
                    Files.copy(entry, file);
                    file.toFile().deleteOnExit();
                }
            }
            return copy;
        }
    }

    private static URI placeOf(Class<?> beside) {
        var place = beside.getResource("cases");
        if (place == null) {
            throw new IllegalStateException("this program comes without its cases");
        }
        try {
            return place.toURI();
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }
}

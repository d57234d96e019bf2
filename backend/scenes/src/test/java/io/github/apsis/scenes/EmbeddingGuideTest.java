package io.github.apsis.scenes;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** The guide shows code that runs: its example is the test beside this one, to the letter. */
class EmbeddingGuideTest {
    private static final Path GUIDE = Path.of("..", "..", "docs", "guide", "embedding.md");
    private static final Path EXAMPLE =
            Path.of("src", "test", "java", "io", "github", "apsis", "scenes", "EmbeddingExampleTest.java");

    @Test
    void the_example_of_the_guide_is_the_test_that_runs() throws IOException {
        String example = between(Files.readString(EXAMPLE), "// example begins\n", "// example ends\n");

        assertThat(between(Files.readString(GUIDE), "<!-- the example -->\n```java\n", "```\n"))
                .isEqualTo(example);
    }

    private static String between(String text, String begin, String end) {
        int from = text.indexOf(begin) + begin.length();
        assertThat(text).contains(begin);
        return text.substring(from, text.indexOf(end, from));
    }
}

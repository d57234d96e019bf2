package io.github.apsis.benchmarks.contacts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.benchmarks.reference.Json;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OutcomeRunTest {
    private static final String PAIR =
            """
            "bodies": [{"name": "cue", "m": 1, "r": 0.5, "x": -3, "y": 0, "vx": 2, "vy": 0},
                       {"name": "t1", "m": 1, "r": 0.5, "x": 0, "y": 0, "vx": 0, "vy": 0}]""";

    @TempDir
    @SuppressWarnings("NullAway.Init") // set by JUnit before each test
    private Path folder;

    private List<OutcomeCase> read(String setup) throws IOException {
        return OutcomeCase.of("set", Json.read(Files.writeString(folder.resolve("set.json"), setup)));
    }

    @Test
    void bodies_are_named_by_the_fields_of_an_outcome() throws IOException {
        List<OutcomeCase> known = read("{" + PAIR
                + ", \"outcome\": [{\"e\": 1, \"cue_vx\": 0, \"target_speed\": \"2\", \"target_directions_deg\": [0]},"
                + "{\"e\": 0.5, \"vx\": [0.5, 1.5]}]}");

        assertThat(known).extracting(OutcomeCase::id).containsExactly("set e=1", "set e=0.5");
        assertThat(known).allSatisfy(one -> assertThat(
                        new OutcomeRun(one, ContactMode.TICK).row().status())
                .isEqualTo("ok"));
    }

    @Test
    void a_wrong_outcome_is_told() throws IOException {
        OutcomeCase wrong = read("{" + PAIR + ", \"outcome\": [{\"e\": 1, \"vx\": [0, 1]}]}")
                .get(0);

        assertThat(new OutcomeRun(wrong, ContactMode.TICK).row().status())
                .isEqualTo("outside tolerance: velocity 5.0e-01 > 1.0e-09");
    }

    /** The listed outcome is only one of those that are as symmetric as the start. */
    @Test
    void another_outcome_is_tolerated_where_it_keeps_a_mirror_symmetry() throws IOException {
        OutcomeCase known =
                read("""
                        {"bodies": [{"name": "l", "m": 1, "r": 0.5, "x": -3, "y": 0, "vx": 1, "vy": 0},
                                    {"name": "r", "m": 1, "r": 0.5, "x": 3, "y": 0, "vx": -1, "vy": 0}],
                         "outcome": [{"e": 0.5, "left_vx": -0.25, "right_vx": 0.25}]}""")
                        .get(0);
        ContactRow row = new OutcomeRun(known, ContactMode.TICK).row();

        assertThat(row.velocityError()).isEqualTo(0.25);
        assertThat(row.status()).isEqualTo("ok");
    }

    @Test
    void an_outcome_of_nobody_is_refused() {
        assertThatThrownBy(() -> read("{" + PAIR + ", \"outcome\": [{\"e\": 1, \"queen_vx\": 0}]}"))
                .hasMessage("an outcome is of queen, and no body is named like that");
    }
}

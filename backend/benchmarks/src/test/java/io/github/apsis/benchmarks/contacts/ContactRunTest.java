package io.github.apsis.benchmarks.contacts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.benchmarks.reference.Json;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class ContactRunTest {
    @TempDir
    @SuppressWarnings("NullAway.Init") // set by JUnit before each test
    private Path folder;

    private static ContactRow row(ContactCase known, ContactMode mode) {
        var run = new ContactRun(known, mode);
        ContactErrors errors = run.errors();
        return ContactRow.of(known, mode, errors, ContactVerdict.of(known, mode, errors, run.dt()));
    }

    private ContactCase altered(String from, String to) throws IOException {
        Path file = HeadOnCase.write(folder, "bump");
        String text = Files.readString(file);
        assertThat(text).contains(from);
        return ContactCase.of("bump", Json.read(Files.writeString(file, text.replace(from, to))));
    }

    @ParameterizedTest
    @EnumSource(ContactMode.class)
    void a_head_on_pair_is_as_a_reader_computes_it_by_hand(ContactMode mode) throws IOException {
        ContactRow row = row(HeadOnCase.read(folder), mode);

        assertThat(row.status()).isEqualTo("ok");
        assertThat(row.eventsInOrder()).isEqualTo("1/1");
        assertThat(row.timeError()).isLessThan(1e-12);
        assertThat(row.positionError()).isLessThan(1e-12);
        assertThat(row.velocityError()).isLessThan(1e-12);
        assertThat(row.energyChange()).isCloseTo(0, within(1e-13)); // 3/16 of 1/2 is what the bounce takes
        assertThat(row.momentumError()).isLessThan(1e-14);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "\"t\": \"1.5\" | \"t\": \"1.500001\" | time of a bounce 1.0e-06 > 1.0e-12 at t=1.500001",
                "[1.75, 0, | [1.75, 1e-6, | position 1.0e-06 > 1.0e-12 at t=2.5",
                "0.75, 0]] | 0.7, 0]] | velocity 5.0e-02 > 1.0e-12 at t=2.5",
                "\"i\": 1, \"j\": 0 | \"i\": 1, \"j\": \"w0\" | bounce 1 is of 0 and 1 at t=1.5 and not of 1 and wall 0 at 1.5",
                "{\"t\": \"1.5\", \"i\": 1, \"j\": 0, \"vn\": -1} | | a bounce of 0 and 1 at t=1.5 is one too many"
            })
    void what_is_not_as_the_case_says_is_told(String from, String to, String complaint) throws IOException {
        ContactCase known = altered(from, to == null ? "" : to);

        assertThat(row(known, ContactMode.EXACT).status()).isEqualTo("outside tolerance: " + complaint);
    }

    @Test
    void a_bounce_that_does_not_come_is_missed() throws IOException {
        ContactCase passing = altered("\"x\": \"2\", \"y\": 0", "\"x\": \"2\", \"y\": 5");

        assertThat(row(passing, ContactMode.EXACT).status())
                .isEqualTo("outside tolerance: bounce 1, of 0 and 1 at t=1.5, did not come");
        assertThat(row(passing, ContactMode.EXACT).eventsInOrder()).isEqualTo("0/1");
    }

    @Test
    void the_amplification_of_a_case_widens_what_is_exact() throws IOException {
        ContactCase known =
                altered("[1.75, 0,", "[1.75, 1e-10,"); // a hundred times too much without conditioning, at home with it
        ContactCase amplified = altered(
                "\"restitution\"",
                "\"conditioning\": {\"times\": [1, 2.5], \"amplification\": [1, 1000]}, \"restitution\"");

        assertThat(row(known, ContactMode.EXACT).status()).startsWith("outside tolerance: position 1.0e-10 > 1.0e-12");
        assertThat(amplified.limit(2.5)).isCloseTo(1e-9, within(1e-20));
        assertThat(amplified.limit(1.75)).isCloseTo(1e-12 * Math.sqrt(1000), within(1e-20));
    }

    /** No tick of 1/100 to 1/1000 meets √2; its sample has a world of its own. */
    @Test
    void a_sample_between_all_ticks_is_read_at_its_own_moment() throws IOException {
        double t = Math.sqrt(2);
        ContactCase known = altered("\"t\": 1, \"state\": [[1, 0,", "\"t\": " + t + ", \"state\": [[" + t + ", 0,");

        assertThat(SampleTicks.meets(t, SampleTicks.ROOM)).isFalse();
        assertThat(row(known, ContactMode.EXACT).positionError()).isLessThan(1e-13);
    }

    @Test
    void a_drop_on_a_slope_bounces_with_the_restitution_of_the_wall() throws IOException {
        // From a height of 2 under g = 4 onto a floor at 1: at 4 after 1, back at 2, up to 0.5, down again after 1
        // more.
        Path file = Files.writeString(
                folder.resolve("drop.json"),
                """
                {"id": "drop", "kind": "contact", "restitution": 1, "wall_restitution": 0.5, "uniform_g": [0, -4],
                 "walls": [{"nx": 0, "ny": 2, "d": 2}], "bodies": [{"m": 3, "r": 0.5, "x": 7, "y": 3.5, "vx": 0, "vy": 0}],
                 "events": [{"t": 1, "i": 0, "j": "w0", "vn": -4}, {"t": 2, "i": 0, "j": "w0", "vn": -2}],
                 "apex_heights": {"values": ["0.5", "0.125"]},
                 "samples": [{"t": 1.5, "state": [[7, 2, 0, 0]]}, {"t": 2.25, "state": [[7, 1.625, 0, 0]]}]}
                """);
        ContactCase known = ContactCase.of("drop", Json.read(file));

        for (ContactMode mode : ContactMode.values()) {
            assertThat(row(known, mode).status()).isEqualTo("ok");
            assertThat(row(known, mode).positionError()).isLessThan(1e-12);
        }
    }

    @Test
    void a_planet_drop_knows_how_far_the_ball_flies() throws IOException {
        // G (m₁ + m₂) = 1, from rest at 2 to a contact at 1: v² / 2 = 1 − 1/2; after it at e v = 1/2 up to 1 / (1 −
        // 1/8).
        double fall = 1 + Math.PI / 2; // √(r³ / 2μ) (acos √(d/r) + √(d/r (1 − d/r))), with r = 2 and d = 1
        Path file = Files.writeString(
                folder.resolve("fall.json"),
                """
                {"id": "fall", "kind": "planet-drop", "G": 1, "restitution": 0.5, "mutual_gravity": true,
                 "bodies": [{"m": 0.75, "r": 0.75, "x": 0, "y": 0, "vx": 0, "vy": 0},
                            {"m": 0.25, "r": 0.25, "x": 0, "y": 2, "vx": 0, "vy": 0}],
                 "events": [{"t": %s, "vn": -1, "apex_after": "%s"}]}
                """
                        .formatted(fall, 8.0 / 7));
        ContactRow row = row(ContactCase.planetDrop("fall", Json.read(file)), ContactMode.TICK);

        assertThat(row.eventsInOrder()).isEqualTo("1/1");
        assertThat(row.timeError()).isLessThan(1e-4); // velocity Verlet at 1/150
        assertThat(row.velocityError()).isLessThan(1e-4);
        assertThat(row.status()).isEqualTo("ok");
    }
}

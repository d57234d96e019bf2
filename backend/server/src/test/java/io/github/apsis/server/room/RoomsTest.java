package io.github.apsis.server.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import io.github.apsis.server.room.Admission.Admitted;
import io.github.apsis.server.room.Admission.Refused;
import java.util.List;
import org.junit.jupiter.api.Test;

class RoomsTest {
    private static final double MOST = 0.8;

    private final FakeTime time = new FakeTime();
    private final Rooms rooms = new Rooms(MOST, List.of(time, time), time, time); // two threads

    private Admission open(String id, double load) {
        return rooms.open(new RoomSpec(id, new TestScene(), 1, 30, 10), load, new RecordingSink());
    }

    @Test
    void rooms_go_where_most_time_is_left() {
        assertThat(open("a", 0.6)).isInstanceOf(Admitted.class);
        assertThat(open("b", 0.3)).isInstanceOf(Admitted.class);
        assertThat(open("c", 0.5)).isInstanceOf(Admitted.class); // beside b
        assertThat(open("d", 0.2)).isInstanceOf(Admitted.class); // beside a

        assertThat(open("e", 0.01)).isInstanceOf(Refused.class);
        assertThat(rooms.all()).hasSize(4);
    }

    @Test
    void a_room_that_would_overload_its_thread_is_refused_with_what_to_do() {
        open("a", 0.3);
        open("b", 0.6);

        Admission admission = open("c", 0.75);

        assertThat(admission).isInstanceOf(Refused.class);
        assertThat(((Refused) admission).reason())
                .contains("no time for the room c", "75 % of a processor", "50 % are left", "apsis.limits.load");
        assertThat(rooms.byId("c")).isEmpty();
    }

    @Test
    void a_load_that_is_no_number_is_refused() {
        assertThat(open("a", Double.NaN)).isInstanceOf(Refused.class);
    }

    /** Its ticks take no time by the clock of this test, whatever was expected of it. */
    @Test
    void what_a_running_room_needs_counts_and_no_longer_what_was_expected() {
        open("a", 0.7);
        open("b", 0.7);
        assertThat(open("c", 0.5)).isInstanceOf(Refused.class);

        rooms.all().forEach(OpenRoom::start);
        time.pass(10 * FakeTime.SECOND);

        assertThat(rooms.byId("a").orElseThrow().load()).isLessThan(0.001);
        assertThat(open("c", 0.5)).isInstanceOf(Admitted.class);
    }

    @Test
    void two_rooms_cannot_have_one_name() {
        open("a", 0.1);

        assertThatIllegalStateException().isThrownBy(() -> open("a", 0.1)).withMessageContaining("a room a already");
    }

    @Test
    void the_load_of_a_scene_is_measured_and_a_quiet_one_is_light() {
        assertThat(WarmUp.run(new TestScene(TestScene.ship(0, 0)), 1))
                .isBetween(1e-6, 0.2); // a tick of a ship is microseconds
    }
}

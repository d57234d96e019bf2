package io.github.apsis.server.room;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.Bodies;
import io.github.apsis.server.room.Outcome.Done;
import io.github.apsis.server.room.Outcome.Reason;
import io.github.apsis.server.room.Outcome.Refused;
import io.github.apsis.server.room.Request.AddRandom;
import io.github.apsis.server.room.Request.RandomBody;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.springframework.boot.test.system.CapturedOutput;
import org.springframework.boot.test.system.OutputCaptureExtension;

@ExtendWith(OutputCaptureExtension.class)
class OpenRoomTest {
    private static final ClientId ANN = new ClientId("ann");

    private final FakeTime time = new FakeTime();
    private final TickThread thread = new TickThread(time, time);
    private final RecordingSink sink = new RecordingSink();
    private final AtomicInteger failures = new AtomicInteger();

    /** A scene whose first world breaks when its force is asked for the hundredth time. */
    private static final class BrokenOnce extends TestScene {
        private int asked;

        BrokenOnce() {
            super(ship(0, 0));
        }

        @Override
        WorldSpec.Builder laws(WorldSpec.Builder walls) {
            return walls.law(this::breakOnce);
        }

        private void breakOnce(Bodies bodies) {
            if (++asked == 100) {
                throw new IllegalStateException("a law of nature was broken");
            }
        }
    }

    @Test
    void a_room_that_throws_is_replaced_by_a_fresh_one() {
        OpenRoom room = open("broken", new BrokenOnce());
        time.pass(FakeTime.SECOND);
        assertThat(failures).hasValue(1);

        time.pass(2 * FakeTime.SECOND);

        assertThat(sink.last().world().tick()).isBetween(150L, 310L); // began again about a second ago
        assertThat(room.nanosSinceLastTick()).isLessThan(FakeTime.SECOND / 100);
    }

    @Test
    void it_is_logged_once_with_room_and_tick(CapturedOutput log) {
        open("broken", new BrokenOnce());

        time.pass(3 * FakeTime.SECOND);

        assertThat(log.getOut().lines().filter(line -> line.contains("ERROR")))
                .singleElement()
                .asString()
                .containsPattern("room broken stopped at tick \\d+");
    }

    @Test
    void other_rooms_on_the_same_thread_do_not_notice() {
        RecordingSink healthy = new RecordingSink();
        open("broken", new BrokenOnce());
        OpenRoom other =
                new OpenRoom(spec("healthy", new TestScene()), healthy, thread, time, failures::incrementAndGet);
        other.start();

        time.pass(3 * FakeTime.SECOND);

        assertThat(healthy.last().world().tick()).isEqualTo(451); // tick 0 and 3 · 150 more
        assertThat(other.pace().lateTicks()).isZero();
    }

    @Test
    void who_asks_while_it_is_down_is_told_that_it_is_busy() {
        OpenRoom room = open("broken", new BrokenOnce());
        List<Outcome> outcomes = new ArrayList<>();
        time.pass(FakeTime.SECOND);

        room.submit(ANN, new AddRandom(RandomBody.SHIP), outcomes::add);
        assertThat(outcomes).containsExactly(new Refused(Reason.ROOM_BUSY));

        time.pass(FakeTime.SECOND);
        room.submit(ANN, new AddRandom(RandomBody.SHIP), outcomes::add);
        time.pass(FakeTime.SECOND);
        assertThat(outcomes.get(1)).isInstanceOf(Done.class);
    }

    @Test
    void a_closed_room_does_not_tick() {
        OpenRoom room = open("closed", new TestScene());
        time.pass(FakeTime.SECOND);
        int frames = sink.frames.size();

        room.close();
        time.pass(FakeTime.SECOND);

        assertThat(sink.frames).hasSize(frames);
    }

    private OpenRoom open(String id, TestScene scene) {
        OpenRoom room = new OpenRoom(spec(id, scene), sink, thread, time, failures::incrementAndGet);
        room.start();
        return room;
    }

    private static RoomSpec spec(String id, TestScene scene) {
        return new RoomSpec(id, scene, 1, 150, 10);
    }
}

package io.github.apsis.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A world that is kept in mid-run and taken up again. */
class RecordingTest {
    private static final int SAVED_AT = 90; // ticks
    private static final int END = 180;
    private static final int SHIPS = 40;
    private static final ShipLimits LIMITS = new ShipLimits(120, 2400);

    /**
     * Ships under orders and without, among rocks that fall on each other and on them: planned courses, random numbers, remembered
     * impulses, deaths. 1100 bodies and more are shared among threads.
     */
    @ParameterizedTest
    @CsvSource({"1, false", "2, false", "8, false", "1, true", "2, true", "8, true"})
    void a_world_that_is_saved_and_loaded_goes_on_as_if_nothing_had_happened(int threads, boolean mortal) {
        Recording saved;
        long atTheSave;
        long atTheEnd;
        try (World world = new World(laws(1, mortal))) {
            Recorder recorder = new Recorder(world);
            crowd().forEach(body -> recorder.apply(new Command.AddBody(body)));
            live(world, recorder, SAVED_AT);
            saved = recorder.recording();
            atTheSave = world.stateHash();
            live(world, recorder, END);
            atTheEnd = world.stateHash();
            assertThat(world.departures().isEmpty()).isEqualTo(!mortal); // something has happened to them
        }

        try (World loaded = saved.replay(laws(threads, mortal))) {
            assertThat(loaded.stateHash()).isEqualTo(atTheSave);
            live(loaded, loaded::apply, END);
            assertThat(loaded.stateHash()).isEqualTo(atTheEnd);
        }
    }

    @Test
    void what_was_refused_is_not_in_it() {
        World world = new World(WorldSpec.builder().build());
        Recorder recorder = new Recorder(world);
        recorder.apply(new Command.AddBody(BodyDef.asteroid(0, 0, 1, 1)));
        recorder.apply(new Command.RemoveBody(new BodyId(7)));
        world.step();
        recorder.apply(new Command.RemoveBody(new BodyId(1)));

        assertThat(recorder.recording().commands())
                .extracting(Recording.Entry::tick)
                .containsExactly(0L, 1L);
        assertThat(recorder.recording().replay(world.spec()).count()).isZero();
    }

    @Test
    void a_world_that_has_begun_cannot_be_recorded() {
        World world = new World(WorldSpec.builder().build());
        world.step();

        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Recorder(world))
                .withMessageContaining("at tick 1");
    }

    @Test
    void a_recording_of_other_laws_says_so() {
        var far = new Command.AddBody(BodyDef.asteroid(500, 0, 1, 1));
        Recording recording = new Recording(List.of(new Recording.Entry(0, far)), 10);

        assertThatIllegalArgumentException()
                .isThrownBy(() -> recording.replay(
                        WorldSpec.builder().walls(Aabb.centred(100, 100), 1).build()))
                .withMessageContaining("OUTSIDE_WORLD");
    }

    @Test
    void commands_that_are_not_in_the_order_of_their_ticks_are_no_recording() {
        var wander = new Command.Wander(new BodyId(1));

        assertThatIllegalArgumentException()
                .isThrownBy(() ->
                        new Recording(List.of(new Recording.Entry(5, wander), new Recording.Entry(4, wander)), 10))
                .withMessageContaining("was 4 after 5");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Recording(List.of(new Recording.Entry(11, wander)), 10))
                .withMessageContaining("0 to 10");
    }

    private interface Commands {
        CommandResult apply(Command command);
    }

    /** Every tenth tick somebody gives a ship an order, or takes it back. */
    private static void live(World world, Commands commands, int until) {
        while (world.tick() < until) {
            if (world.tick() % 10 == 0) {
                BodyId ship = new BodyId(1 + world.tick() / 10 % SHIPS);
                commands.apply(
                        world.tick() % 30 == 0
                                ? new Command.Wander(ship)
                                : new Command.SeekTarget(ship, world.tick() - 80, 60));
            }
            world.step();
        }
    }

    private static void live(World world, Recorder recorder, int until) {
        live(world, recorder::apply, until);
    }

    private static WorldSpec laws(int threads, boolean mortal) {
        WorldSpec.Builder laws = WorldSpec.builder()
                .gravity(2)
                .contacts(0.3)
                .walls(Aabb.centred(450, 450), 0.8)
                .seed(7)
                .threads(threads);
        return (mortal ? laws.mortalShips() : laws).build();
    }

    private static List<BodyDef> crowd() {
        var rng = new Rng(3);
        return IntStream.range(0, 1150)
                .mapToObj(i -> {
                    // A place of its own for each, 25 apart; rocks are fast enough to hit some ships.
                    double x = -425 + 25 * (i * 7 % 1150 % 34);
                    double y = -425 + 25 * (i * 7 % 1150 / 34);
                    double fast = i < SHIPS ? 20 : 150;
                    BodyDef body = i < SHIPS
                            ? BodyDef.ship(x, y, 12, 6, LIMITS)
                            : BodyDef.asteroid(x, y, 5, rng.between(2, 9));
                    return body.moving(rng.between(-fast, fast), rng.between(-fast, fast));
                })
                .toList();
    }
}

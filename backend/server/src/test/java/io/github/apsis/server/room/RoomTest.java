package io.github.apsis.server.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.ShipReading;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.engine.math.Vec2;
import io.github.apsis.scenes.Scene;
import io.github.apsis.scenes.SceneCatalogue;
import io.github.apsis.server.room.Outcome.Done;
import io.github.apsis.server.room.Outcome.Reason;
import io.github.apsis.server.room.Outcome.Refused;
import io.github.apsis.server.room.Request.AddRandom;
import io.github.apsis.server.room.Request.Deselect;
import io.github.apsis.server.room.Request.MoveSelectedShips;
import io.github.apsis.server.room.Request.RandomBody;
import io.github.apsis.server.room.Request.Remove;
import io.github.apsis.server.room.Request.Select;
import io.github.apsis.server.room.ShipEvent.What;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class RoomTest {
    private static final ClientId ANN = new ClientId("ann");
    private static final ClientId BOB = new ClientId("bob");
    private static final BodyId SHIP = new BodyId(1);
    private static final BodyId OTHER_SHIP = new BodyId(2);
    private static final BodyId ROCK = new BodyId(3);

    private final RecordingSink sink = new RecordingSink();
    private final List<Outcome> outcomes = new ArrayList<>();
    private final Room room =
            room(new TestScene(TestScene.ship(-50, 0), TestScene.ship(50, 0), BodyDef.asteroid(0, 100, 3, 5)), 6);

    @Test
    void a_command_queued_before_tick_7_shows_in_frame_7() {
        ticks(6);
        submit(ANN, new AddRandom(RandomBody.SHIP));

        ticks(1);

        assertThat(sink.frames.get(5).world().count()).isEqualTo(3);
        assertThat(sink.frames.get(6).world().tick()).isEqualTo(7);
        assertThat(sink.frames.get(6).world().count()).isEqualTo(4);
        assertThat(outcomes).containsExactly(new Done(List.of(new BodyId(4)), 7));
    }

    @ParameterizedTest
    @EnumSource(names = {"PLANET", "ASTEROID", "SHIP"})
    void a_random_body_is_of_the_kind_that_was_asked_for(RandomBody kind) {
        List.of(SHIP, OTHER_SHIP, ROCK).forEach(body -> submit(ANN, new Remove(body)));
        submit(ANN, new AddRandom(kind));

        ticks(1);

        int i = sink.last().world().indexOf(new BodyId(4));
        assertThat(sink.last().world().kind(i)).isEqualTo(BodyKind.valueOf(kind.name()));
    }

    @Test
    void an_asteroid_has_a_look_from_its_birth_to_its_end() {
        submit(ANN, new AddRandom(RandomBody.ASTEROID));
        ticks(1);
        assertThat(sink.last().appearances()).containsOnlyKeys(new BodyId(4));

        submit(ANN, new Remove(new BodyId(4)));
        ticks(1);

        assertThat(sink.last().appearances()).isEmpty();
    }

    @Test
    void what_is_selected_is_seen_by_all_and_ends_with_its_last_owner() {
        submit(ANN, new Select(SHIP));
        submit(BOB, new Select(SHIP));
        ticks(1);
        assertThat(sink.last().selected()).containsExactly(SHIP);

        submit(ANN, new Deselect(SHIP));
        ticks(1);
        assertThat(sink.last().selected()).containsExactly(SHIP);

        room.leave(BOB);
        ticks(1);
        assertThat(sink.last().selected()).isEmpty();
    }

    @Test
    void a_removed_body_is_nobody_s_selection() {
        submit(ANN, new Select(ROCK));
        submit(BOB, new Remove(ROCK));

        ticks(1);

        assertThat(sink.last().selected()).isEmpty();
        assertThat(sink.last().world().indexOf(ROCK)).isNegative();
    }

    @Test
    void a_selected_ship_goes_to_the_point_and_stops_there() {
        submit(ANN, new Select(SHIP));
        submit(ANN, new Select(ROCK));
        submit(ANN, new MoveSelectedShips(120, -80));

        ticks(10 * TickLoop.TICKS_PER_SECOND);

        int i = sink.last().world().indexOf(SHIP);
        assertThat(outcomes.get(2)).isEqualTo(new Done(List.of(SHIP), 1));
        assertThat(sink.last().world().x(i)).isCloseTo(120, within(1.0));
        assertThat(sink.last().world().y(i)).isCloseTo(-80, within(1.0));
        assertThat(new Vec2(sink.last().world().vx(i), sink.last().world().vy(i)).length())
                .isLessThan(1);
        assertThat(sink.last().world().target(sink.last().world().indexOf(OTHER_SHIP)))
                .isEmpty();
    }

    @Test
    void the_nearest_of_several_ships_takes_the_point_itself() {
        submit(ANN, new Select(SHIP));
        submit(ANN, new Select(OTHER_SHIP));
        submit(ANN, new MoveSelectedShips(100, 0));

        ticks(1);

        var world = sink.last().world();
        assertThat(world.target(world.indexOf(OTHER_SHIP))).contains(new Vec2(100, 0));
        Vec2 other = world.target(world.indexOf(SHIP)).orElseThrow();
        assertThat(Math.hypot(other.x() - 100, other.y())).isCloseTo(2.5 * 4, within(1e-9));
    }

    @Test
    void everybody_hears_ten_times_a_second_of_the_ship_that_he_selected_last() {
        submit(ANN, new Select(SHIP));
        submit(ANN, new MoveSelectedShips(120, -80));
        submit(ANN, new Select(OTHER_SHIP));
        submit(BOB, new Select(OTHER_SHIP));
        submit(ANN, new Select(SHIP)); // once more

        ticks(TickLoop.TICKS_PER_SECOND);

        assertThat(sink.ships).hasSize(10).allSatisfy(ships -> {
            assertThat(ships.byClient()).containsOnlyKeys(ANN, BOB);
            assertThat(of(ANN, ships).ship()).isEqualTo(SHIP);
            assertThat(of(ANN, ships).target()).contains(new Vec2(120, -80));
            assertThat(of(BOB, ships).ship()).isEqualTo(OTHER_SHIP);
            assertThat(of(BOB, ships).target()).isEmpty();
        });
    }

    private static ShipReading of(ClientId client, WatchedShips ships) {
        return Objects.requireNonNull(ships.byClient().get(client));
    }

    @Test
    void a_ship_that_nobody_has_selected_last_costs_nothing() {
        submit(ANN, new Select(SHIP));
        submit(ANN, new Select(ROCK));
        submit(BOB, new Select(SHIP));
        submit(BOB, new Deselect(SHIP));

        ticks(TickLoop.TICKS_PER_SECOND);

        assertThat(sink.ships).isEmpty();
    }

    @Test
    void when_the_last_one_is_gone_the_one_before_it_is_the_last() {
        submit(ANN, new Select(SHIP));
        submit(ANN, new Select(OTHER_SHIP));
        submit(BOB, new Remove(OTHER_SHIP));

        ticks(TickLoop.TICKS_PER_SECOND);

        assertThat(sink.ships)
                .allSatisfy(ships -> assertThat(of(ANN, ships).ship()).isEqualTo(SHIP));
    }

    @Test
    void a_ship_that_arrives_is_told_of_once() {
        submit(ANN, new Select(SHIP));
        submit(ANN, new MoveSelectedShips(-20, 30));

        ticks(10 * TickLoop.TICKS_PER_SECOND);

        assertThat(sink.events).hasSize(1);
        assertThat(sink.events.get(0).events()).singleElement().satisfies(event -> {
            assertThat(event.what()).isEqualTo(What.ARRIVED);
            assertThat(event.ship()).isEqualTo(SHIP);
            assertThat(event.encounter()).isEmpty();
        });
    }

    @Test
    void a_rock_that_hits_a_ship_is_an_event_with_its_name_and_speed() {
        // The rock is too fast for the ship to get away.
        Room dangerous = room(
                new TestScene(
                        TestScene.ship(0, 0), BodyDef.asteroid(-190, 0, 3, 5).moving(3000, 0)) {
                    @Override
                    WorldSpec.Builder laws(WorldSpec.Builder walls) {
                        return walls.contacts(0.8);
                    }
                },
                6);

        for (int i = 0; i < TickLoop.TICKS_PER_SECOND; i++) {
            dangerous.tick();
        }

        assertThat(dangerous.ships().collisions()).isPositive();
        ShipEvent first = sink.events.get(0).events().get(0);
        assertThat(first.what()).isEqualTo(What.COLLIDED);
        assertThat(first.ship()).isEqualTo(new BodyId(1));
        ShipEvent.Encounter met = first.encounter().orElseThrow();
        assertThat(met.other()).isEqualTo(new BodyId(2));
        assertThat(met.kind()).isEqualTo(BodyKind.ASTEROID);
        assertThat(met.closingSpeed())
                .isCloseTo(3000, within(100.0)); // the ship has fled for a moment, at 200 u/s² and no faster than 100
    }

    @Test
    void mortal_ships_that_meet_are_two_events_and_nobody_s_selection() {
        Room deadly = room(
                new TestScene(TestScene.ship(0, 0), TestScene.ship(-100, 0).moving(30_000, 0)) {
                    @Override
                    WorldSpec.Builder laws(WorldSpec.Builder walls) {
                        return walls.contacts(0.8).mortalShips();
                    }
                },
                6);
        deadly.submit(ANN, new Select(SHIP), outcomes::add);

        for (int i = 0; i < TickLoop.TICKS_PER_SECOND; i++) {
            deadly.tick();
        }

        assertThat(sink.last().world().count()).isZero();
        assertThat(sink.last().selected()).isEmpty();
        assertThat(sink.ships).isEmpty();
        assertThat(deadly.ships().collisions()).isEqualTo(1);
        assertThat(sink.events).hasSize(1);
        assertThat(sink.events.get(0).events())
                .extracting(ShipEvent::what, ShipEvent::ship, event -> event.encounter()
                        .map(ShipEvent.Encounter::other))
                .containsExactlyInAnyOrder(
                        tuple(What.DESTROYED, SHIP, Optional.of(OTHER_SHIP)),
                        tuple(What.DESTROYED, OTHER_SHIP, Optional.of(SHIP)));
        RoomReadings last = sink.readings.get(sink.readings.size() - 1);
        assertThat(last.conservation().orElseThrow().drift().momentum()).isZero();
    }

    @Test
    void watching_changes_nothing_of_what_is_watched() {
        Scene scene = SceneCatalogue.byName("belt-and-swarm").orElseThrow();
        Room watched = new Room(new RoomSpec("watched", scene, 1, 150, 300), sink, () -> Pace.AT_START, () -> 1);
        Room alone =
                new Room(new RoomSpec("alone", scene, 1, 1, 300), new RecordingSink(), () -> Pace.AT_START, () -> 0.4);
        BodyId ship = new BodyId(230);

        for (int tick = 0; tick < 5 * TickLoop.TICKS_PER_SECOND; tick++) {
            if (tick == 100) {
                watched.submit(BOB, new Select(new BodyId(231)), outcomes::add);
            }
            if (tick == 200) {
                for (Room each : List.of(watched, alone)) {
                    each.submit(ANN, new Select(ship), outcomes::add);
                    each.submit(ANN, new MoveSelectedShips(300, -200), outcomes::add);
                    each.submit(ANN, new AddRandom(RandomBody.ANY), outcomes::add);
                }
            }
            if (tick == 300) {
                alone.leave(ANN);
            }
            watched.tick();
            alone.tick();
        }

        assertThat(sink.ships).isNotEmpty();
        assertThat(outcomes).allMatch(Done.class::isInstance);
        assertThat(watched.worldHash()).isEqualTo(alone.worldHash());
    }

    @Test
    void one_client_moves_only_what_it_has_selected_itself() {
        submit(ANN, new Select(SHIP));
        submit(BOB, new MoveSelectedShips(0, 0));

        ticks(1);

        assertThat(outcomes.get(1)).isEqualTo(new Refused(Reason.NO_SHIP_SELECTED));
    }

    @Test
    void a_target_outside_the_walls_is_refused_and_changes_nothing() {
        submit(ANN, new Select(SHIP));
        submit(ANN, new MoveSelectedShips(201, 0));

        ticks(1);

        assertThat(outcomes.get(1)).isEqualTo(new Refused(Reason.OUTSIDE_WORLD));
        assertThat(sink.last().world().target(0)).isEmpty();
    }

    @Test
    void what_is_not_there_cannot_be_selected_or_removed() {
        submit(ANN, new Select(new BodyId(99)));
        submit(ANN, new Remove(new BodyId(99)));

        ticks(1);

        assertThat(outcomes).containsExactly(new Refused(Reason.NO_SUCH_BODY), new Refused(Reason.NO_SUCH_BODY));
    }

    @Test
    void a_full_room_takes_no_more() {
        for (int i = 0; i < 4; i++) {
            submit(ANN, new AddRandom(RandomBody.SHIP));
        }

        ticks(1);

        assertThat(outcomes.subList(0, 3)).allMatch(Done.class::isInstance);
        assertThat(outcomes.get(3)).isEqualTo(new Refused(Reason.WORLD_FULL));
    }

    @Test
    void where_no_place_is_left_a_body_is_refused() {
        submit(ANN, new AddRandom(RandomBody.PLANET)); // 180 across, in the midst of the others

        ticks(1);

        assertThat(outcomes).containsExactly(new Refused(Reason.NO_ROOM));
    }

    @Test
    void a_full_queue_refuses_at_once_and_empties_tick_by_tick() {
        for (int i = 0; i <= Room.QUEUE_CAPACITY; i++) {
            submit(ANN, new Select(SHIP));
        }
        assertThat(outcomes).containsExactly(new Refused(Reason.ROOM_BUSY));

        ticks(1);

        assertThat(outcomes).hasSize(1 + Room.MOST_COMMANDS_PER_TICK);
    }

    @Test
    void a_closed_room_answers_everybody() {
        submit(ANN, new Select(SHIP));
        room.close();
        submit(BOB, new Select(SHIP));

        assertThat(outcomes).containsExactly(new Refused(Reason.ROOM_BUSY), new Refused(Reason.ROOM_BUSY));
    }

    @Test
    void frames_come_at_their_rate_and_readings_four_times_a_second() {
        Room slow = new Room(new RoomSpec("slow", new TestScene(), 1, 30, 10), sink, () -> Pace.AT_START, () -> 1);

        for (int i = 0; i < 2 * TickLoop.TICKS_PER_SECOND; i++) {
            slow.tick();
        }

        assertThat(sink.frames).hasSize(60).allMatch(frame -> frame.world().tick() % 5 == 0);
        assertThat(sink.readings).hasSize(8);
    }

    /** At half of real time 75 ticks are a second. */
    @Test
    void a_slow_clock_says_so_and_makes_frames_no_rarer() {
        Room slow = new Room(new RoomSpec("slow", new TestScene(), 1, 30, 10), sink, () -> Pace.AT_START, () -> 0.5);

        for (int i = 0; i < TickLoop.TICKS_PER_SECOND; i++) {
            slow.tick();
        }

        assertThat(sink.frames).hasSize(60).allMatch(frame -> frame.speed() == 0.5);
        assertThat(sink.readings).hasSize(8);
        assertThat(sink.last().world().time()).isEqualTo(1); // a tick is 1/150 of a second as ever
    }

    @Test
    void a_world_left_alone_keeps_its_energy_and_momentum() {
        Room free = room(new TestScene(BodyDef.asteroid(0, 0, 3, 5).moving(7, 4)), 10);

        for (int i = 0; i < 1000; i++) {
            free.tick();
        }

        Conservation last =
                sink.readings.get(sink.readings.size() - 1).conservation().orElseThrow();
        assertThat(last.drift().energy().orElseThrow()).isCloseTo(0, within(1e-12));
        assertThat(last.drift().momentum()).isCloseTo(0, within(1e-12));
        assertThat(last.drift().angularMomentum().orElseThrow()).isCloseTo(0, within(1e-12));
        assertThat(last.now().energy().orElseThrow()).isCloseTo(0.5 * 3 * 65, within(1e-9)); // m·v²/2
    }

    @Test
    void a_body_that_left_the_world_of_itself_is_nobody_s_selection_and_no_drift() {
        Room wild =
                room(new TestScene(BodyDef.asteroid(0, 0, 3, 5).moving(1e151, 0), BodyDef.asteroid(0, 50, 3, 5)), 10);
        wild.submit(ANN, new Select(new BodyId(1)), outcomes::add);

        for (int i = 0; i < 2 * TickLoop.TICKS_PER_SECOND; i++) {
            wild.tick();
        }

        assertThat(sink.last().world().count()).isEqualTo(1);
        assertThat(sink.last().selected()).isEmpty();
        assertThat(wild.bodies()).isEqualTo(1);
        RoomReadings last = sink.readings.get(sink.readings.size() - 1);
        assertThat(last.conservation().orElseThrow().drift().momentum()).isZero();
        assertThat(last.gravitySolver()).isEqualTo("none");
    }

    @Test
    void a_frame_rate_must_divide_the_tick_rate() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new RoomSpec("odd", new TestScene(), 1, 60, 10))
                .withMessageContaining("divide 150")
                .withMessageContaining("was 60");
    }

    @Test
    void what_leaves_a_room_cannot_be_changed() {
        submit(ANN, new Select(SHIP));
        ticks(1);
        Set<BodyId> selected = sink.last().selected();

        submit(ANN, new Deselect(SHIP));
        ticks(1);

        assertThat(selected).containsExactly(SHIP).isUnmodifiable();
    }

    private Room room(TestScene scene, int maxBodies) {
        return new Room(new RoomSpec("test", scene, 1, 150, maxBodies), sink, () -> Pace.AT_START, () -> 1);
    }

    private void submit(ClientId client, Request request) {
        room.submit(client, request, outcomes::add);
    }

    private void ticks(int count) {
        for (int i = 0; i < count; i++) {
            room.tick();
        }
    }
}

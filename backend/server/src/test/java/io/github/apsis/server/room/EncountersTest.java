package io.github.apsis.server.room;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.server.room.Encounters.Collision;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class EncountersTest {
    private static final BodyId SHIP = new BodyId(1);
    private static final BodyId OTHER_SHIP = new BodyId(2);
    private static final BodyId ROCK = new BodyId(3);
    private static final BodyId OTHER_ROCK = new BodyId(4);

    private final Encounters encounters = new Encounters();
    private long tick;

    @BeforeEach
    void two_ships_and_two_rocks() {
        encounters.add(SHIP, BodyKind.SHIP);
        encounters.add(OTHER_SHIP, BodyKind.SHIP);
        encounters.add(ROCK, BodyKind.ASTEROID);
        encounters.add(OTHER_ROCK, BodyKind.ASTEROID);
    }

    @Test
    void a_ship_that_bounces_off_a_rock_has_collided_whoever_is_named_first() {
        assertThat(tick(3, 1)).containsExactly(new Collision(SHIP, ROCK, BodyKind.ASTEROID, 5));
        assertThat(tick(2, 4)).containsExactly(new Collision(OTHER_SHIP, OTHER_ROCK, BodyKind.ASTEROID, 5));
        assertThat(encounters.tally().collisions()).isEqualTo(2);
    }

    @Test
    void two_ships_that_meet_are_one_collision() {
        assertThat(tick(1, 2)).containsExactly(new Collision(SHIP, OTHER_SHIP, BodyKind.SHIP, 5));
        assertThat(encounters.tally().collisions()).isEqualTo(1);
    }

    @Test
    void rocks_among_themselves_and_walls_do_not_count() {
        assertThat(tick(3, 4)).isEmpty();
        assertThat(tick(1, -1)).isEmpty();
    }

    @Test
    void a_pair_that_rattles_is_one_collision_until_it_has_been_apart_for_a_second() {
        tick(1, 3);
        for (int i = 0; i < 20; i++) {
            pass(Encounters.APART_TICKS - 1);
            assertThat(tick(1, 3)).isEmpty();
        }
        pass(Encounters.APART_TICKS);

        assertThat(tick(1, 3)).hasSize(1);
        assertThat(encounters.tally().collisions()).isEqualTo(2);
    }

    @Test
    void a_rate_is_per_minute_of_each_ship() {
        tick(1, 3);
        pass(9000 - 1); // one minute
        assertThat(encounters.tally().shipMinutes()).isEqualTo(2);
        assertThat(encounters.tally().collisionsPerShipMinute()).isEqualTo(0.5);

        encounters.remove(OTHER_SHIP);
        pass(9000);

        assertThat(encounters.tally().shipMinutes()).isEqualTo(3);
        assertThat(encounters.tally().collisionsPerShipMinute()).isCloseTo(1 / 3.0, within(1e-15));
    }

    @Test
    void a_room_without_ships_has_no_rate() {
        assertThat(new Encounters().tally().collisionsPerShipMinute()).isZero();
    }

    private List<Collision> tick(long first, long second) {
        encounters.begin(++tick);
        encounters.bounced(tick / 150.0, first, second, 5, 60);
        return List.copyOf(encounters.end());
    }

    private void pass(int ticks) {
        for (int i = 0; i < ticks; i++) {
            encounters.begin(++tick);
            encounters.end();
        }
    }
}

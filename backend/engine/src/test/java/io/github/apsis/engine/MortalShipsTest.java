package io.github.apsis.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.assertj.core.api.Assertions.tuple;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.diagnostics.Drift;
import io.github.apsis.engine.math.Aabb;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Worlds in which a ship does not survive what it runs into. Its engine is too weak to avoid anything. */
class MortalShipsTest {
    private static final ShipLimits DRIFTING = new ShipLimits(100, 1e-9);
    private static final BodyId SHIP = new BodyId(1);
    private static final BodyId OTHER = new BodyId(2);

    @Test
    void a_ship_that_hits_a_rock_is_gone_and_the_rock_has_its_impulse() {
        World world = new World(laws().mortalShips().build());
        world.add(ship(-20, 0).moving(60, 0));
        world.add(BodyDef.asteroid(20, 0, 15, 5));
        Conserved before = world.conserved();

        run(world, 150);

        assertThat(world.departures()).singleElement().satisfies(departure -> {
            assertThat(departure.body()).isEqualTo(SHIP);
            assertThat(departure.reason()).isEqualTo(Departure.Reason.COLLIDED);
            assertThat(departure.with()).contains(OTHER);
            assertThat(departure.tick()).isEqualTo(78); // 31 at 60, less the hair that the engine takes off: 77.5 ticks
        });
        assertThat(world.count()).isEqualTo(1);
        // j = 1.8 · 60 / (1/5 + 1/15) = 405. Of 300 that came in the rock has 405, and the wreck took −105 with it.
        Conserved after = world.conserved();
        assertThat(before.momentumX()).isEqualTo(300);
        assertThat(after.momentumX()).isCloseTo(405, within(1e-6));
        assertThat(after.kinetic()).isCloseTo(0.5 * 15 * 27 * 27, within(1e-6));
    }

    @Test
    void the_books_hold_what_the_bounce_took_and_nothing_drifts_from_then_on() {
        World world = new World(laws().mortalShips().build());
        world.add(ship(-20, 0).moving(60, 0));
        world.add(BodyDef.asteroid(20, 0, 15, 5));
        run(world, 78);
        Conserved then = world.conserved();
        // (1 − 0.8²)/2 · μ v², with μ = 3.75: the restitution's share, and none for the leaving.
        assertThat(world.ledger().energy()).isCloseTo(-2430, within(1e-6));
        assertThat(world.ledger().momentumX()).isCloseTo(0, within(1e-6));

        run(world, 1000);

        Drift drift = Drift.between(then, world.conserved());
        assertThat(drift.energy().orElseThrow()).isCloseTo(0, within(1e-13));
        assertThat(drift.momentum()).isCloseTo(0, within(1e-13));
    }

    @Test
    void of_two_ships_that_meet_none_is_left() {
        World world = new World(laws().mortalShips().build());
        world.add(ship(-20, 0).moving(60, 0));
        world.add(ship(20, 0));

        run(world, 150);

        assertThat(world.count()).isZero();
        assertThat(world.departures())
                .extracting(Departure::body, Departure::with)
                .containsExactly(tuple(SHIP, Optional.of(OTHER)), tuple(OTHER, Optional.of(SHIP)));
    }

    @Test
    void rocks_among_themselves_and_walls_end_nobody() {
        World world =
                new World(laws().walls(Aabb.centred(100, 100), 1).mortalShips().build());
        world.add(ship(0, 50).moving(90, 0));
        world.add(BodyDef.asteroid(-20, 0, 15, 5).moving(60, 0));
        world.add(BodyDef.asteroid(20, 0, 15, 5));
        List<Long> seconds = new ArrayList<>();
        world.onBounce((time, first, second, closing, impulse) -> seconds.add(second));

        run(world, 300);

        assertThat(seconds).contains(-2L, 3L); // the right wall, and a rock
        assertThat(world.departures()).isEmpty();
    }

    @Test
    void what_lies_against_a_ship_at_rest_does_no_harm() {
        World world = new World(laws().mortalShips().build());
        world.add(ship(0, 0));
        world.add(BodyDef.asteroid(9, 0, 15, 5));

        run(world, 300);

        assertThat(world.departures()).isEmpty();
    }

    @Test
    void unless_a_scene_says_so_ships_bounce_and_go_on() {
        World world = new World(laws().build());
        world.add(ship(-20, 0).moving(60, 0));
        world.add(BodyDef.asteroid(20, 0, 15, 5));

        run(world, 150);

        assertThat(world.departures()).isEmpty();
        assertThat(world.snapshot().vx(0)).isCloseTo(60 - 405 / 5.0, within(1e-6));
    }

    @Test
    void a_world_without_contacts_cannot_have_mortal_ships_and_says_so() {
        assertThatIllegalStateException()
                .isThrownBy(() -> WorldSpec.builder().mortalShips().build())
                .withMessageContaining("call contacts(restitution) too");
    }

    @Test
    void the_exact_steps_of_the_adaptive_method_know_it_as_well() {
        World world = new World(WorldSpec.builder()
                .adaptive(1e-14)
                .exactContacts(0.8)
                .mortalShips()
                .build());
        world.add(ship(-20, 0).moving(60, 0));
        world.add(BodyDef.asteroid(20, 0, 15, 5));

        run(world, 150);

        assertThat(world.departures()).extracting(Departure::with).containsExactly(Optional.of(OTHER));
        assertThat(world.conserved().momentumX()).isCloseTo(405, within(1e-6));
    }

    private static WorldSpec.Builder laws() {
        return WorldSpec.builder().contacts(0.8);
    }

    private static BodyDef ship(double x, double y) {
        return BodyDef.ship(x, y, 5, 4, DRIFTING);
    }

    private static void run(World world, int ticks) {
        for (int i = 0; i < ticks; i++) {
            world.step();
        }
    }
}

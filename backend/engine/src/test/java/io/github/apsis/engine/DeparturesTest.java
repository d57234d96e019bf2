package io.github.apsis.engine;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;
import org.junit.jupiter.api.Test;

class DeparturesTest {
    private static final double TOO_FAST = 2 * Bodies.FASTEST;

    private final World world = new World(WorldSpec.builder().build());

    @Test
    void who_asks_after_every_tick_misses_nobody() {
        long known = 0;
        for (int tick = 1; tick <= 5; tick++) {
            for (int k = 0; k < 700; k++) {
                world.add(BodyDef.planet(0, 0, 1, 1).moving(TOO_FAST, 0));
            }
            world.step();

            assertThat(world.departuresSince(known)).hasSize(700);
            assertThat(world.departuresSince(known).get(699).body()).isEqualTo(new BodyId(700L * tick));
            known = world.departed();
        }

        assertThat(known).isEqualTo(3500);
        assertThat(world.departuresSince(known)).isEmpty();
    }

    @Test
    void all_of_one_tick_are_told_however_many() {
        for (int k = 0; k < 3000; k++) {
            world.add(BodyDef.planet(0, 0, 1, 1).moving(TOO_FAST, 0));
        }

        world.step();

        assertThat(world.departures()).hasSize(3000);
    }

    @Test
    void a_world_that_loses_bodies_for_ever_remembers_the_last_thousand_and_how_many() {
        for (int tick = 0; tick < 5000; tick++) {
            world.add(BodyDef.planet(0, 0, 1, 1).moving(TOO_FAST, 0));
            world.step();
        }
        world.step();

        assertThat(world.departed()).isEqualTo(5000);
        assertThat(world.departures()).hasSize(1000);
        assertThat(world.departures().get(0).body()).isEqualTo(new BodyId(4001));
        assertThat(world.departuresSince(0)).as("the others are forgotten").isEqualTo(world.departures());
    }
}

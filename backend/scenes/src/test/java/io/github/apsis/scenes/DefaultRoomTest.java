package io.github.apsis.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.diagnostics.Drift;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/**
 * Three minutes of the room that everybody sees first, without a clock and without visitors. A whole day of it:
 * {@code apsis-bench run belt-and-swarm --seconds 86400}.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class DefaultRoomTest {
    private static final int SECONDS = Integer.getInteger("apsis.defaultRoomSeconds", 180);

    private final World world =
            SceneCatalogue.byName("belt-and-swarm").orElseThrow().world(1);
    private final int bodies = world.count();
    private final Conserved start = world.conserved();
    private double worstEnergy;
    private double worstMomentum;
    private double worstAngularMomentum;
    private double deepest;

    @BeforeAll
    void let_it_run() {
        for (int second = 0; second < SECONDS; second++) {
            for (int tick = 0; tick < 150; tick++) {
                world.step();
            }
            Drift drift = Drift.between(start, world.conserved());
            worstEnergy = Math.max(worstEnergy, Math.abs(drift.energy().orElseThrow()));
            worstMomentum = Math.max(worstMomentum, drift.momentum());
            worstAngularMomentum = Math.max(
                    worstAngularMomentum, Math.abs(drift.angularMomentum().orElseThrow()));
            deepest = Math.max(deepest, deepestOverlap(world.snapshot()));
        }
    }

    @Test
    void nobody_is_lost() {
        assertThat(world.count()).isEqualTo(bodies);
        assertThat(world.departures()).isEmpty();
    }

    @Test
    void engines_walls_and_restitution_book_all_the_work_they_do() {
        assertThat(world.ledger().energy()).isNotCloseTo(0, within(1e4)); // there is much to book
        // Verlet on eccentric orbits round the planet, and bounces among them.
        assertThat(worstEnergy).isLessThan(1e-5);
    }

    @Test
    void engines_walls_and_the_fixed_planet_book_all_momentum_they_give() {
        assertThat(worstMomentum).isLessThan(1e-12);
    }

    @Test
    void angular_momentum_changes_by_what_is_booked() {
        // The line of centres at the time of a bounce is a dt²/8 from where both have moved on.
        assertThat(worstAngularMomentum).isLessThan(1e-7);
    }

    @Test
    void nobody_ends_a_second_inside_another() {
        assertThat(deepest).as("radii").isLessThan(1e-3);
    }

    private static double deepestOverlap(WorldSnapshot now) {
        double deepest = 0;
        for (int i = 0; i < now.count(); i++) {
            for (int j = i + 1; j < now.count(); j++) {
                double distance = Math.hypot(now.x(j) - now.x(i), now.y(j) - now.y(i));
                double overlap = now.radius(i) + now.radius(j) - distance;
                deepest = Math.max(deepest, overlap / Math.min(now.radius(i), now.radius(j)));
            }
        }
        return deepest;
    }
}

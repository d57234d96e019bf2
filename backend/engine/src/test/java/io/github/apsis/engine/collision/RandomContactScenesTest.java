package io.github.apsis.engine.collision;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.collision.RandomContactScene.Pull;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.LongStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * What holds for one second of any crowd. More crowds: {@code -Dapsis.contactScenes=5000}; every failure names its seed.
 */
class RandomContactScenesTest {
    private static final long SCENES = Long.getLong("apsis.contactScenes", 200);

    private static List<ContactRun> runs = List.of();

    @BeforeAll
    static void run_all_for_a_second() {
        runs = LongStream.range(0, SCENES)
                .mapToObj(seed -> ContactRun.of(new RandomContactScene(seed)))
                .toList();
    }

    @Test
    void every_body_is_still_there_with_numbers_for_place_and_velocity() {
        assertThat(runs).filteredOn(run -> !run.isFinite()).isEmpty();
    }

    @Test
    void momentum_is_kept_but_for_what_walls_fixed_bodies_and_fields_have_booked() {
        // Ten thousand impulses of 1e-16 each, at random.
        assertThat(broken(run -> run.momentumError() < 1e-12)).isEmpty();
    }

    @Test
    void what_contacts_and_walls_take_and_parting_gives_is_booked() {
        // Rounding grows with the ratio of the masses that press each other: 6e-10 is the worst of 3000 scenes.
        assertThat(broken(run -> !keepsBooks(run) || run.energyError() < 1e-9)).isEmpty();
    }

    @Test
    void no_crowd_ever_has_more_energy_than_it_began_with() {
        // Not even what the books would excuse: contacts only take. Rounding of 150 ticks of a parabola.
        assertThat(broken(run -> !keepsBooks(run) || run.energyGain() < 1e-12)).isEmpty();
    }

    @Test
    void nobody_lies_deeper_in_another_than_a_hundredth_of_a_radius() {
        // Circles are rigid: what is left is how far the search for the impulses of a crowd may stop from the end.
        assertThat(broken(run -> !run.bornApart() || run.deepest() < 0.01)).isEmpty();
    }

    @Test
    void nobody_lies_deeper_in_a_wall_than_a_hundredth_of_a_radius() {
        assertThat(broken(run -> !run.bornApart() || run.deepestInWall() < 0.01))
                .isEmpty();
    }

    @Test
    void angular_momentum_is_kept_where_no_force_bends_a_path() {
        assertThat(broken(run -> !run.bornApart()
                        || run.scene().pull() != Pull.NONE
                        || run.scene().isPeriodic()
                        || run.angularError() < 1e-10))
                .isEmpty();
    }

    @Test
    void energy_of_bodies_that_pull_each_other_grows_by_no_more_than_the_integrator_allows() {
        // Verlet is wrong by (ω dt)² of what is exchanged, ω = 3 and dt = 1/150: 4e-4.
        assertThat(broken(run -> !isFallingTogether(run) || run.energyGain() < 4e-4))
                .isEmpty();
    }

    @Test
    void the_same_seed_ends_in_the_same_bits() {
        assertThat(broken(run -> ContactRun.hashAgain(run.scene()) == run.hash()))
                .isEmpty();
    }

    private static boolean keepsBooks(ContactRun run) {
        return run.bornApart() && run.scene().hasEnergy() && run.scene().pull() != Pull.GRAVITY;
    }

    private static boolean isFallingTogether(ContactRun run) {
        return run.bornApart() && run.scene().hasEnergy() && run.scene().pull() == Pull.GRAVITY;
    }

    /** The crowds that break a law, of those that are still there. */
    private static List<ContactRun> broken(Predicate<ContactRun> law) {
        return runs.stream().filter(ContactRun::isFinite).filter(law.negate()).toList();
    }
}

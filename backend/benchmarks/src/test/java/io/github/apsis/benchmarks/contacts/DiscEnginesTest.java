package io.github.apsis.benchmarks.contacts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.benchmarks.discs.Contender;
import io.github.apsis.benchmarks.discs.DiscScene;
import io.github.apsis.benchmarks.discs.DiscScenes;
import io.github.apsis.benchmarks.discs.DiscScenes.Target;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** All engines are told of the same scenes: what any of them gets right, each must have been told right. */
class DiscEnginesTest {
    @ParameterizedTest
    @EnumSource
    void a_cradle_with_gaps_hands_its_speed_on(Contender engine) {
        assertThat(CradleRow.of(DiscScenes.cradle(5, 0.05), engine).speedError())
                .isLessThan(1e-6); // single precision
    }

    /** dyn4j as it comes gains some hundredths, which is its own; a scene told wrong loses or gains a half. */
    @ParameterizedTest
    @EnumSource
    void a_gas_stays_in_its_box_and_keeps_its_energy(Contender engine) {
        SceneRow row = new SceneTrial(DiscScenes.gas(50), 60, 20, 60).run(engine);

        assertThat(row.energyDrift()).isCloseTo(0, within(engine.isOurs() ? 1e-13 : 0.1));
        assertThat(row.deepest()).isLessThan(1);
        assertThat(row.micros()).isPositive();
        assertThat(row.steps()).isEqualTo(60);
    }

    @ParameterizedTest
    @EnumSource
    void a_pile_falls_and_stays_above_the_floor(Contender engine) {
        SceneRow row = new SceneTrial(DiscScenes.pile(9), 150, 100, 60).run(engine);

        assertThat(row.speedEnd()).isLessThan(10); // from 40 at the floor
        assertThat(row.deepestEnd()).isLessThan(0.5);
    }

    @Test
    void a_run_that_takes_too_long_says_where_it_stopped() {
        SceneRow row = new SceneTrial(DiscScenes.gas(500), 1_000_000, 10, 1).run(Contender.APSIS_TICK);

        assertThat(row.steps()).isBetween(1, 999_999);
        assertThat(row.note()).isEqualTo("stopped after 1 s");
    }

    @ParameterizedTest
    @EnumSource(names = {"APSIS_TICK", "APSIS_EXACT"})
    void no_bullet_of_ours_goes_through_anything(Contender engine) {
        for (Target target : Target.values()) {
            BulletRow row = BulletRow.of(target, engine);

            assertThat(row.through()).isZero();
            assertThat(row.speedError()).isLessThan(1e-12);
        }
    }

    /** The first numbers of the generator from 12345, worked out apart: 87628868 and 71072467. */
    @Test
    void a_gas_starts_where_any_program_puts_it() {
        DiscScene.Disc first = DiscScenes.gas(1000).discs().get(0);
        double side = Math.sqrt(1000 * Math.PI * 4 / 0.2);

        assertThat(first.x()).isEqualTo(2 + 87628868 / 4294967296.0 * (side - 4));
        assertThat(first.y()).isEqualTo(2 + 71072467 / 4294967296.0 * (side - 4));
    }
}

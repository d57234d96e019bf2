package io.github.apsis.engine.collision;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.ReferenceCase;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Contacts against their true states, at the tolerance for exact contact times: 1e-12 × max(1, amplification), where the
 * amplification is what a case itself makes of an error in its start.
 */
class ReferenceContactsTest {
    private static final double EXACT = 1e-12;

    /** The samples of the free cases fall on ticks of this length, half as long again as the usual one. */
    private static final double DT = 1.0 / 100;

    @ParameterizedTest
    @ValueSource(
            strings = {
                "pair-head-on-e00",
                "pair-head-on-e05",
                "pair-head-on-e08",
                "pair-head-on-e10",
                "pair-oblique-e00",
                "pair-oblique-e05",
                "pair-oblique-e08",
                "pair-oblique-e10",
                "cradle-e10",
                "cradle-e09",
                "bullet-hit",
                "bullet-graze",
                "bullet-miss"
            })
    void free_discs_are_where_they_should_be(String id) {
        ReferenceCase contacts = ReferenceCase.of(id);
        World world = contacts.world(WorldSpec.builder()
                .dt(DT)
                .contacts(contacts.number("restitution"))
                .build());

        assertStates(contacts, world);
    }

    @Test
    void a_gas_of_a_hundred_discs_follows_its_471_collisions() {
        ReferenceCase gas = ReferenceCase.of("gas100");
        World world = gas.world(WorldSpec.builder()
                .dt(DT)
                .contacts(1)
                .walls(new Aabb(0, 0, 10, 10), 1)
                .build());

        assertStates(gas, world);
    }

    @Test
    void a_ball_bounces_twenty_times_to_the_height_it_should() {
        ReferenceCase drop = ReferenceCase.of("floor-drop");
        double e = drop.number("wall_restitution");
        World world = drop.world(WorldSpec.builder()
                .law(new UniformField(0, -9.81))
                .walls(new Aabb(-10, 0, 10, 100), e)
                .build());

        // The field is uniform, so the parabola of a tick is the true path: as exact as free flight, until the bounces
        // are
        // shorter than two ticks; that is 9.08 s, after the last sample.
        assertStates(drop, world);
    }

    private static void assertStates(ReferenceCase contacts, World world) {
        var amplification = contacts.node("conditioning").get("amplification");
        int k = 0;
        for (ReferenceCase.Sample sample : contacts.samples()) {
            ReferenceCase.run(world, sample.tick(world.spec().dt()));
            double tolerance = EXACT * Math.max(1, amplification.get(k++).asDouble());
            assertThat(sample.positionError(world.snapshot()) / contacts.number("length_scale"))
                    .as("positions at %s", sample.time())
                    .isLessThanOrEqualTo(tolerance);
            assertThat(sample.velocityError(world.snapshot()) / contacts.number("velocity_scale"))
                    .as("velocities at %s", sample.time())
                    .isLessThanOrEqualTo(tolerance);
        }
    }
}

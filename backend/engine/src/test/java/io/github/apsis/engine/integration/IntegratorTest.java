package io.github.apsis.engine.integration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.ReferenceCase;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.WorldSpec.Integration;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.force.UniformField;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class IntegratorTest {
    @Test
    void verlet_has_order_two() {
        assertThat(measuredOrder(Integration.VELOCITY_VERLET, false)).isCloseTo(2, within(0.1));
    }

    @Test
    void semi_implicit_euler_has_order_one_in_energy() {
        // From a pericentre its position error falls like order 2 by symmetry; the energy error tells.
        assertThat(measuredOrder(Integration.SEMI_IMPLICIT_EULER, true)).isCloseTo(1, within(0.1));
    }

    @ParameterizedTest
    @EnumSource(names = {"YOSHIDA4", "PEFRL"})
    void two_methods_have_order_four(Integration method) {
        assertThat(measuredOrder(method, false)).isCloseTo(4, within(0.1));
        assertThat(measuredOrder(method, true)).isCloseTo(4, within(0.1));
    }

    @Test
    void the_long_composition_has_order_eight() {
        // Ticks long enough that its error stands above rounding: 30 and 60 to an orbit.
        ReferenceCase orbit = ReferenceCase.of("kepler-e05-equal");
        double coarse = error(orbit, Integration.SYMPLECTIC8, 1.0 / 8, false);
        double fine = error(orbit, Integration.SYMPLECTIC8, 1.0 / 16, false);

        assertThat(Math.log(coarse / fine) / Math.log(2)).isCloseTo(8, within(0.1));
    }

    private static double measuredOrder(Integration method, boolean byEnergy) {
        ReferenceCase orbit = ReferenceCase.of("kepler-e05-equal");
        double coarse = error(orbit, method, 1.0 / 150, byEnergy);
        double fine = error(orbit, method, 1.0 / 300, byEnergy);
        return Math.log(coarse / fine) / Math.log(2);
    }

    private static double error(ReferenceCase orbit, Integration method, double dt, boolean byEnergy) {
        World world = orbit.world(WorldSpec.builder()
                .gravity(orbit.number("G"))
                .integration(method)
                .dt(dt)
                .build());
        double energy0 = world.conserved().energy().orElseThrow();
        double worst = 0;
        var sample = orbit.samples().get(2);
        while (world.tick() < sample.tick(dt)) {
            world.step();
            worst = Math.max(worst, Math.abs(world.conserved().energy().orElseThrow() - energy0));
        }
        return byEnergy ? worst : sample.positionError(world.snapshot());
    }

    @ParameterizedTest
    @EnumSource(Integration.class)
    void free_flight_is_exact(Integration method) {
        World world = new World(WorldSpec.builder().integration(method).dt(0.25).build());
        world.add(BodyDef.asteroid(1, 2, 1, 1).moving(4, -8));

        ReferenceCase.run(world, 1000);

        // Powers of two: no rounding at all, but in the coefficients of a composition and what they do to each sum.
        boolean dyadic =
                method != Integration.YOSHIDA4 && method != Integration.PEFRL && method != Integration.SYMPLECTIC8;
        assertThat(world.snapshot().x(0)).isCloseTo(1001, within(dyadic ? 0 : 1e-10));
        assertThat(world.snapshot().y(0)).isCloseTo(-1998, within(dyadic ? 0 : 2e-10));
    }

    @Test
    void verlet_is_exact_in_a_uniform_field() {
        World world = new World(
                WorldSpec.builder().law(new UniformField(0, -8)).dt(0.25).build());
        world.add(BodyDef.asteroid(0, 100, 1, 1));

        ReferenceCase.run(world, 16);

        assertThat(world.snapshot().y(0)).isEqualTo(100 - 0.5 * 8 * 16);
        assertThat(world.snapshot().vy(0)).isEqualTo(-32);
    }
}

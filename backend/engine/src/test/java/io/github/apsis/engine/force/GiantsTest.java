package io.github.apsis.engine.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Rng;
import org.junit.jupiter.api.Test;

class GiantsTest {
    private static final int BELT = 3000; // of mass 1, around a planet of 10⁵
    private static final double PLANET = 1e5;

    @Test
    void a_planet_adds_nothing_to_the_error_of_a_tree() {
        double errorOfBelt = error(belt(1));

        double errorAroundPlanet = error(belt(PLANET));

        // Forty times as much when the pull of the planet goes through the cells.
        assertThat(errorAroundPlanet).isCloseTo(errorOfBelt, within(0.01 * errorOfBelt));
    }

    @Test
    void a_planet_is_pulled_as_by_the_direct_sum_and_momentum_stays() {
        Bodies bodies = belt(PLANET);
        Bodies exact = belt(PLANET);

        new TreeGravity(1, 0, 1).apply(bodies);
        new DirectGravity(1, 0).apply(exact);

        double scale = Math.hypot(exact.ax(0), exact.ay(0));
        assertThat(bodies.ax(0)).isCloseTo(exact.ax(0), within(1e-11 * scale)); // 3000 roundings of terms that cancel
        assertThat(bodies.ay(0)).isCloseTo(exact.ay(0), within(1e-11 * scale));
        double sum = 0;
        double size = 0;
        for (int i = 0; i < bodies.count(); i++) {
            sum += bodies.mass(i) * bodies.ax(i);
            size += bodies.mass(i) * Math.abs(bodies.ax(i));
        }
        assertThat(sum).isCloseTo(0, within(1e-13 * size));
    }

    @Test
    void two_of_equal_mass_and_dust_between_them_are_summed_directly() {
        Bodies bodies = new Bodies();
        bodies.add(BodyDef.planet(-10, 0, 1000, 1));
        bodies.add(BodyDef.planet(10, 0, 1000, 1));
        bodies.add(BodyDef.asteroid(0, 0, 1, 0.1));

        new TreeGravity(1, 0, 1).apply(bodies);

        assertThat(bodies.ax(0)).isCloseTo(1000.0 / 400 + 1.0 / 100, within(1e-15));
        assertThat(bodies.ax(2)).isZero();
    }

    private static Bodies belt(double planet) {
        var rng = new Rng(11);
        var bodies = new Bodies();
        bodies.add(BodyDef.planet(3, 1, planet, 30));
        for (int i = 0; i < BELT; i++) {
            double angle = rng.between(0, 2 * Math.PI);
            double r = rng.between(100, 300);
            bodies.add(BodyDef.asteroid(r * StrictMath.cos(angle), r * StrictMath.sin(angle), 1, 1));
        }
        return bodies;
    }

    /** Of the accelerations, root mean square. */
    private static double error(Bodies bodies) {
        new TreeGravity(1, 0, 1).apply(bodies);
        double[] ax = new double[bodies.count()];
        double[] ay = new double[bodies.count()];
        for (int i = 0; i < bodies.count(); i++) {
            ax[i] = bodies.ax(i);
            ay[i] = bodies.ay(i);
        }
        bodies.clearAccelerations();
        new DirectGravity(1, 0).apply(bodies);
        double squares = 0;
        for (int i = 0; i < bodies.count(); i++) {
            double dx = ax[i] - bodies.ax(i);
            double dy = ay[i] - bodies.ay(i);
            squares += dx * dx + dy * dy;
        }
        return Math.sqrt(squares / bodies.count());
    }
}

package io.github.apsis.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class KeplerOrbitTest {
    @ParameterizedTest
    @CsvSource({"0, 10", "0.2, 77", "0.5, -100", "0.9, 5", "0.97, 179", "0.2056, 534.8"})
    void the_eccentric_anomaly_solves_keplers_equation(double e, double meanAnomalyDegrees) {
        double anomaly = new KeplerOrbit(1, e, meanAnomalyDegrees, 0).eccentricAnomaly();

        double miss = anomaly - e * Math.sin(anomaly) - Math.toRadians(meanAnomalyDegrees);
        assertThat(Math.IEEEremainder(miss, 2 * Math.PI)).isCloseTo(0, within(1e-14)); // some units in the last place
    }

    @Test
    void the_textbook_case_of_meeus_is_met() {
        // Meeus, Astronomical Algorithms, example 30.a: e = 0.1, M = 5°, E = 5.554589°.
        double anomaly = new KeplerOrbit(1, 0.1, 5, 0).eccentricAnomaly();

        assertThat(Math.toDegrees(anomaly)).isCloseTo(5.554589, within(5e-7)); // half of the last digit printed
    }

    @Test
    void perihelion_lies_at_its_longitude_and_is_passed_at_right_angles() {
        KeplerOrbit.State state = new KeplerOrbit(2, 0.5, 90, 90).state(1);

        assertThat(state.x()).isCloseTo(0, within(1e-15));
        assertThat(state.y()).isCloseTo(1, within(1e-15)); // a (1 − e)
        assertThat(state.vx()).isCloseTo(-Math.sqrt(1.5), within(1e-15)); // √(μ/a · (1+e)/(1−e))
        assertThat(state.vy()).isCloseTo(0, within(1e-15));
    }

    @ParameterizedTest
    @CsvSource({"0, 20", "0.3, 200", "0.8, 350"})
    void energy_and_angular_momentum_are_those_of_the_ellipse(double e, double meanLongitude) {
        KeplerOrbit.State s = new KeplerOrbit(3, e, meanLongitude, 40).state(7);

        double energy = (s.vx() * s.vx() + s.vy() * s.vy()) / 2 - 7 / Math.sqrt(s.x() * s.x() + s.y() * s.y());
        assertThat(energy).isCloseTo(-7.0 / 6, within(1e-14)); // −μ / 2a
        double spin = s.x() * s.vy() - s.y() * s.vx();
        assertThat(spin).isCloseTo(Math.sqrt(7 * 3 * (1 - e * e)), within(1e-14)); // √(μ a (1 − e²))
    }
}

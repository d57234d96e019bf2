package io.github.apsis.benchmarks.accuracy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OrbitRunTest {
    private static final double DT = 1.0 / 150;

    @TempDir
    @SuppressWarnings("NullAway.Init") // set by JUnit before each test
    private Path folder;

    @Test
    void the_position_error_of_leapfrog_on_a_circle_is_its_phase_error() throws IOException {
        NBodyCase circle = TwoBodyCase.read(folder);

        OrbitErrors errors = new OrbitRun(circle, Setting.fixed(Method.LEAPFROG, DT)).errors();

        // From a circular start the mean motion is off by dt²/8 (the start is not circular to the map: dt²/6 less
        // dt²/24), up
        // to the radial wobble; the body is at radius 1/2 and t = 3.
        assertThat(errors.last().time()).isEqualTo(3);
        assertThat(errors.last().position()).isBetween(0.1 * DT * DT, DT * DT);
        assertThat(errors.samples().get(0).position()).isLessThan(errors.last().position());
        assertThat(errors.last().energy()).isLessThan(1e-8); // order 4 in dt on a circle: dt⁴/4
        assertThat(errors.last().spin()).isLessThan(1e-13);
        assertThat(errors.momentum()).isLessThan(1e-14);
    }

    @Test
    void halving_the_step_divides_the_position_error_by_four() throws IOException {
        NBodyCase circle = TwoBodyCase.read(folder);

        double coarse = new OrbitRun(circle, Setting.fixed(Method.LEAPFROG, DT))
                .errors()
                .last()
                .position();
        double fine = new OrbitRun(circle, Setting.fixed(Method.LEAPFROG, DT / 2))
                .errors()
                .last()
                .position();

        assertThat(coarse / fine).isCloseTo(4, within(0.01));
    }

    @Test
    void a_unit_of_time_costs_some_cpu() throws IOException {
        NBodyCase circle = TwoBodyCase.read(folder);

        double micros = new OrbitRun(circle, Setting.fixed(Method.LEAPFROG, DT)).cpuMicrosPerUnit(3);

        assertThat(micros).isBetween(0.1, 10_000.0); // 150 steps of 1 ns to 70 µs: a loaded machine is no failure
    }
}

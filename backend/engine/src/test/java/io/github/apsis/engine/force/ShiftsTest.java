package io.github.apsis.engine.force;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class ShiftsTest {
    private static final int ORDER = CellKernels.ORDER;
    private static final double ROUNDING = 1e-14; // of sums of a few tens of terms of size 1

    @Test
    void the_moments_of_a_body_are_those_about_the_other_centre() {
        double[] moment = new double[3 * CellKernels.MOMENTS];
        int child = CellKernels.MOMENTS;
        int parent = 2 * CellKernels.MOMENTS;
        putMoments(moment, child, 3, 0.4, -0.7);

        Shifts.addMoments(moment, child, parent, -0.3, 0.9);

        double[] expected = new double[CellKernels.MOMENTS];
        putMoments(expected, 0, 3, 0.4 - 0.3, -0.7 + 0.9);
        for (int k = 0; k < CellKernels.MOMENTS; k++) {
            assertThat(moment[parent + k]).isCloseTo(expected[k], within(ROUNDING));
        }
    }

    @Test
    void the_locals_of_a_polynomial_are_its_derivatives_at_the_other_centre() {
        double[] local = new double[2 * CellKernels.LOCALS];
        int child = CellKernels.LOCALS;
        putDerivatives(local, 0, 0.2, 0.1);

        Shifts.addLocals(local, 0, child, -0.5, 0.6);

        double[] expected = new double[CellKernels.LOCALS];
        putDerivatives(expected, 0, 0.2 - 0.5, 0.1 + 0.6);
        for (int k = 1; k < CellKernels.LOCALS; k++) {
            assertThat(local[child + k]).isCloseTo(expected[k], within(factorial(ORDER) * ROUNDING));
        }
    }

    @Test
    void what_stands_at_the_other_centre_is_added_to() {
        double[] moment = new double[2 * CellKernels.MOMENTS];
        putMoments(moment, 0, 1, 0.1, 0.2);
        putMoments(moment, CellKernels.MOMENTS, 1, 0.1, 0.2);

        Shifts.addMoments(moment, 0, CellKernels.MOMENTS, 0, 0);

        for (int k = 0; k < CellKernels.MOMENTS; k++) {
            assertThat(moment[CellKernels.MOMENTS + k]).isEqualTo(2 * moment[k]);
        }
    }

    /** M_ab = m X^a Y^b / (a! b!). */
    private static void putMoments(double[] moment, int at, double m, double x, double y) {
        for (int n = 0; n < ORDER; n++) {
            for (int b = 0; b <= n; b++) {
                moment[at + n * (n + 1) / 2 + b] =
                        m * Math.pow(x, n - b) * Math.pow(y, b) / (factorial(n - b) * factorial(b));
            }
        }
    }

    /** Of f = (x − y/2 + 1/4)^6, all derivatives up to the sixth. */
    private static void putDerivatives(double[] local, int at, double x, double y) {
        double root = x - 0.5 * y + 0.25;
        for (int n = 0; n <= ORDER; n++) {
            for (int b = 0; b <= n; b++) {
                local[at + n * (n + 1) / 2 + b] =
                        factorial(ORDER) / factorial(ORDER - n) * Math.pow(-0.5, b) * Math.pow(root, ORDER - n);
            }
        }
    }

    private static double factorial(int n) {
        return n < 2 ? 1 : n * factorial(n - 1);
    }
}

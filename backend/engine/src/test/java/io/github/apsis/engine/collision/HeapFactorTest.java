package io.github.apsis.engine.collision;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.math.Rng;
import org.junit.jupiter.api.Test;

/** K z = v, solved and multiplied out again. */
class HeapFactorTest {
    private static final int BODIES = 300;

    private final double[] x = new double[BODIES];
    private final double[] y = new double[BODIES];
    private final int[] first = new int[4000];
    private final int[] second = new int[4000];
    private final double[] ax = new double[4000];
    private final double[] ay = new double[4000];
    private final double[] bx = new double[4000];
    private final double[] by = new double[4000];
    private final double[] weight = new double[4000];
    private int contacts;

    @Test
    void solutions_fulfil_the_equations() {
        var factor = new HeapFactor();
        for (long seed = 1; seed <= 30; seed++) {
            scatter(seed, 0.05 + 0.01 * seed); // from islands to one heap in which everybody touches many
            factor.analyse(BODIES, x, y, contacts, first, second);
            factor.factor(ax, ay, bx, by, weight);
            var rng = new Rng(seed);
            double[] v = new double[2 * BODIES];
            for (int i = 0; i < v.length; i++) {
                v[i] = rng.between(-1, 1);
            }
            double[] z = v.clone();

            factor.solve(z);

            double[] again = multiply(z);
            for (int i = 0; i < v.length; i++) {
                // 2^-53 times the largest weight, 1e6, times the square root of 600 numbers, and some.
                assertThat(Math.abs(again[i] - v[i]))
                        .as("unknown %d, seed %d", i, seed)
                        .isLessThan(1e-7);
            }
        }
    }

    private double[] multiply(double[] z) {
        double[] sum = z.clone();
        for (int k = 0; k < contacts; k++) {
            double speed = 0;
            if (first[k] >= 0) {
                speed += ax[k] * z[2 * first[k]] + ay[k] * z[2 * first[k] + 1];
            }
            if (second[k] >= 0) {
                speed += bx[k] * z[2 * second[k]] + by[k] * z[2 * second[k] + 1];
            }
            speed *= weight[k];
            if (first[k] >= 0) {
                sum[2 * first[k]] += ax[k] * speed;
                sum[2 * first[k] + 1] += ay[k] * speed;
            }
            if (second[k] >= 0) {
                sum[2 * second[k]] += bx[k] * speed;
                sum[2 * second[k] + 1] += by[k] * speed;
            }
        }
        return sum;
    }

    /** Points in a square; those nearer than a length touch, and some touch what nothing moves. */
    private void scatter(long seed, double near) {
        var rng = new Rng(seed);
        for (int i = 0; i < BODIES; i++) {
            x[i] = rng.nextDouble();
            y[i] = rng.nextDouble();
        }
        contacts = 0;
        for (int i = 0; i < BODIES; i++) {
            for (int j = i + 1; j < BODIES && contacts < first.length - BODIES; j++) {
                if (Math.hypot(x[i] - x[j], y[i] - y[j]) < near) {
                    add(i, j, rng);
                }
            }
            if (rng.nextDouble() < 0.1) {
                add(i, -1, rng);
            } else if (rng.nextDouble() < 0.1) {
                add(-1, i, rng);
            }
        }
    }

    private void add(int a, int b, Rng rng) {
        int k = contacts++;
        first[k] = a;
        second[k] = b;
        ax[k] = rng.between(-1, 1);
        ay[k] = rng.between(-1, 1);
        bx[k] = rng.between(-1, 1);
        by[k] = rng.between(-1, 1);
        weight[k] = rng.nextDouble() < 0.2 ? 0 : Math.pow(10, rng.between(-3, 6));
    }
}

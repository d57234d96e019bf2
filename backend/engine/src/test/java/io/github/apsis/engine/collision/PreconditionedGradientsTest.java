package io.github.apsis.engine.collision;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Rng;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Systems of a heap with a factor that was made for another, against v = K z multiplied out. */
class PreconditionedGradientsTest {
    private static final int SIDE = 20;
    private static final double STIFF = 1e5;

    /** Squares of the residual lose half of the digits; what is asked for is far above that. */
    private static final double ENOUGH = 1e-9;

    private final Bodies bodies = new Bodies();
    private final ContactMatrix matrix = new ContactMatrix();
    private final HeapMatrix heap = new HeapMatrix();
    private final PreconditionedGradients gradients = new PreconditionedGradients();
    private final double[] weight = new double[2 * SIDE * SIDE];

    @Test
    void a_factor_serves_when_three_contacts_of_hundreds_have_changed() {
        lattice(0);
        heap.set(matrix, bodies);
        Arrays.fill(weight, 0, heap.size(), STIFF);
        heap.factor(weight);
        lattice(1e-8);
        heap.set(matrix, bodies);
        weight[5] = 0;
        weight[100] = 0;
        weight[500] = 0;
        double[] right = speeds();
        double[] z = right.clone();

        assertThat(gradients.solve(heap, weight, ENOUGH, z)).isTrue();

        assertThat(worstResidual(z, right))
                .isLessThan(2 * ENOUGH); // the residual is carried along, not measured: a little more
    }

    @Test
    void a_factor_of_quite_another_heap_is_told() {
        lattice(0);
        heap.set(matrix, bodies);
        for (int k = 0; k < heap.size(); k++) {
            weight[k] = k % 2 == 0 ? STIFF : 0;
        }
        heap.factor(weight);
        for (int k = 0; k < heap.size(); k++) {
            weight[k] = STIFF - weight[k];
        }
        double[] z = speeds();

        assertThat(gradients.solve(heap, weight, ENOUGH, z)).isFalse();
    }

    private double[] speeds() {
        var rng = new Rng(7);
        double[] speeds = new double[heap.unknowns()];
        Arrays.setAll(speeds, i -> rng.between(-1, 1));
        return speeds;
    }

    private double worstResidual(double[] z, double[] right) {
        double[] speed = new double[heap.size()];
        double[] product = new double[heap.unknowns()];
        heap.separate(z, speed);
        for (int k = 0; k < heap.size(); k++) {
            speed[k] *= weight[k];
        }
        heap.spread(speed, product);
        double worst = 0;
        for (int i = 0; i < heap.unknowns(); i++) {
            worst = Math.max(worst, Math.abs(right[i] - z[i] - product[i]));
        }
        return worst;
    }

    /** Circles on a square lattice, each in contact with those beside and above it, all normals turned by as much. */
    private void lattice(double turn) {
        while (bodies.count() < SIDE * SIDE) {
            int i = bodies.count();
            bodies.add(BodyDef.asteroid(2 * (i % SIDE), 2 * (i / SIDE), 1, 1));
        }
        matrix.begin(2 * SIDE * SIDE, bodies);
        for (int i = 0; i < SIDE * SIDE; i++) {
            if (i % SIDE < SIDE - 1) {
                matrix.add(i, i + 1, 1, turn);
            }
            if (i / SIDE < SIDE - 1) {
                matrix.add(i, i + SIDE, -turn, 1);
            }
        }
    }
}

package io.github.apsis.engine.collision;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Rng;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** Impulses of heaps, found directly, against the conditions that define them. */
class HeapSolverTest {
    private static final int COLUMNS = 24;
    private static final int ROWS = 16;
    private static final double FALL = 0.1; // of everybody in a tick

    private final Bodies bodies = new Bodies();
    private final ContactMatrix matrix = new ContactMatrix();
    private final double[] lack = new double[8 * COLUMNS * ROWS];
    private final double[] impulse = new double[lack.length];
    private final double[] speed = new double[lack.length];

    /**
     * Circles of one size, packed as closely as they go, wedged between three walls: there are more contacts than ways to move, so
     * that impulses are not unique, and A is singular. Velocities are unique, and what they have to fulfil is the test.
     */
    @Test
    void circles_that_are_wedged_are_held_by_pushes_alone() {
        crystal(0);

        double most = hold();

        assertThat(worst()).isLessThan(4e-7 * most); // as right as HeapSolver was asked for
        assertThat(largest()).as("a push that nothing asks for").isLessThan(10 * ROWS * COLUMNS * FALL);
    }

    /** The same with gaps here and there, so that some circles fall and others are left alone. */
    @Test
    void a_heap_with_gaps_closes_none() {
        for (long seed = 1; seed <= 10; seed++) {
            crystal(seed);

            double most = hold();

            assertThat(worst()).as("seed %d", seed).isLessThan(4e-7 * most);
        }
    }

    /** Tick after tick with the same solver, which goes on from its factors as far as they serve. */
    @Test
    void a_heap_that_has_changed_a_little_is_held_as_exactly() {
        crystal(1);
        var solver = new HeapSolver(1e5);
        var rng = new Rng(2);
        Arrays.fill(impulse, 0);
        for (int tick = 0; tick < 30; tick++) {
            double most = mostLacking();

            solver.improve(matrix, bodies, lack, most, 1e-9 * most, impulse);

            assertThat(worst()).as("tick %d", tick).isLessThan(4e-9 * most); // as right as it was asked for
            change(rng, tick % 10 == 9 ? 0.1 : 1e-3);
        }
    }

    /** Conjugate gradients find the same velocities when they are given the time, which is thousands of rounds. */
    @Test
    void conjugate_gradients_agree_in_the_end() {
        crystal(3);
        hold();
        var solver = new ImpulseSolver();
        solver.begin(matrix.size(), bodies);
        for (int k = 0; k < matrix.size(); k++) {
            double scale = matrix.scale(k);
            solver.add(matrix.first(k), matrix.second(k), matrix.normalX(k) / scale, matrix.normalY(k) / scale, 0);
            solver.measured(k, lack[k] / scale);
        }

        int rounds = solver.solve(1e-9, 0, 100_000);

        solver.push();
        matrix.spread(impulse);
        assertThat(rounds).isGreaterThan(200);
        for (int i = 0; i < bodies.count(); i++) {
            assertThat(Math.abs(solver.pushX(i) - matrix.velocityX(i)))
                    .as("body %d", i)
                    .isLessThan(1e-5 * FALL);
            assertThat(Math.abs(solver.pushY(i) - matrix.velocityY(i)))
                    .as("body %d", i)
                    .isLessThan(1e-5 * FALL);
        }
    }

    private double hold() {
        double most = mostLacking();
        Arrays.fill(impulse, 0);
        new HeapSolver(1e5).improve(matrix, bodies, lack, most, 1e-7 * most, impulse);
        return most;
    }

    private double mostLacking() {
        double most = 0;
        for (int k = 0; k < matrix.size(); k++) {
            most = Math.max(most, -lack[k]);
        }
        return most;
    }

    /** Leaves a share of the contacts out, and turns the normals of the others by some millionths. */
    private void change(Rng rng, double share) {
        var before = new ContactMatrix();
        before.begin(matrix.size(), bodies);
        for (int k = 0; k < matrix.size(); k++) {
            double turn = rng.between(-1e-6, 1e-6);
            double nx = matrix.normalX(k) / matrix.scale(k);
            double ny = matrix.normalY(k) / matrix.scale(k);
            if (rng.nextDouble() >= share || matrix.second(k) < 0) {
                lack[before.size()] = lack[k];
                impulse[before.size()] = impulse[k];
                before.add(matrix.first(k), matrix.second(k), nx - turn * ny, ny + turn * nx);
            }
        }
        matrix.begin(lack.length, bodies);
        for (int k = 0; k < before.size(); k++) {
            double scale = before.scale(k);
            matrix.add(before.first(k), before.second(k), before.normalX(k) / scale, before.normalY(k) / scale);
        }
    }

    /** By how much the worst contact misses w ≥ 0, and w = 0 where it pushes. */
    private double worst() {
        matrix.multiply(impulse, speed);
        double worst = 0;
        for (int k = 0; k < matrix.size(); k++) {
            double w = lack[k] + speed[k];
            assertThat(impulse[k]).isNotNegative();
            worst = Math.max(worst, impulse[k] > 0 ? Math.abs(w) : -w);
        }
        return worst;
    }

    private double largest() {
        return Arrays.stream(impulse).max().orElseThrow();
    }

    /** Every circle touches up to six others; with a seed, each contact is open a little with a chance of one in four. */
    private void crystal(long seed) {
        var rng = new Rng(seed);
        while (bodies.count() > 0) {
            bodies.remove(bodies.count() - 1);
        }
        for (int row = 0; row < ROWS; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                bodies.add(BodyDef.asteroid(2 * column + row % 2, Math.sqrt(3) * row, 1, 1));
            }
        }
        matrix.begin(lack.length, bodies);
        for (int row = 0; row < ROWS; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                int i = row * COLUMNS + column;
                int above = i + COLUMNS - 1 + row % 2;
                boolean isFirst = column == 0;
                boolean isLast = column == COLUMNS - 1;
                boolean isTop = row == ROWS - 1;
                if (!isLast) {
                    touch(i, i + 1, 1, 0, open(seed, rng));
                }
                if (!isTop && (row % 2 == 1 || !isFirst)) {
                    touch(i, above, -0.5, Math.sqrt(0.75), open(seed, rng));
                }
                if (!isTop && (row % 2 == 0 || !isLast)) {
                    touch(i, above + 1, 0.5, Math.sqrt(0.75), open(seed, rng));
                }
                if (isFirst && row % 2 == 0) {
                    touch(i, -1, -1, 0, 0);
                }
                if (isLast && row % 2 == 1) {
                    touch(i, -2, 1, 0, 0);
                }
                if (row == 0) {
                    touch(i, -3, 0, -1, -FALL);
                }
            }
        }
    }

    private static double open(long seed, Rng rng) {
        return seed > 0 && rng.nextDouble() < 0.25 ? rng.between(0, FALL) : 0;
    }

    private void touch(int a, int b, double nx, double ny, double speed) {
        int k = matrix.size();
        double root = matrix.add(a, b, nx, ny);
        lack[k] = speed / root;
    }
}

package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.reference.Json;
import io.github.apsis.engine.WorldSnapshot;
import tools.jackson.databind.JsonNode;

/**
 * Where all bodies truly are at one moment, and how fast.
 *
 * @param time since the start
 * @param state x, y, vx, vy of each body, in the order of the case; vx and vy are NaN where the case does not say
 */
record MotionSample(double time, double[][] state) {
    static MotionSample of(double time, JsonNode state, int bodies) {
        if (state.size() != bodies) {
            throw new IllegalArgumentException(
                    "its sample at " + time + " has " + state.size() + " bodies and not " + bodies);
        }
        double[][] all = new double[bodies][4];
        for (int i = 0; i < bodies; i++) {
            JsonNode one = state.get(i);
            if (one.size() != 2 && one.size() != 4) {
                throw new IllegalArgumentException("its sample at " + time + " has " + one.size() + " numbers for body "
                        + i + " and not x, y, vx, vy");
            }
            for (int k = 0; k < 4; k++) {
                all[i][k] = k < one.size() ? Json.valueOf(one.get(k), "a value at " + time) : Double.NaN;
            }
        }
        return new MotionSample(time, all);
    }

    /** The largest distance of a body from its true place, length; infinite when a body is lost. */
    double positionError(WorldSnapshot now) {
        double worst = 0;
        for (int i = 0; i < state.length; i++) {
            worst = Math.max(
                    worst,
                    now.count() == state.length
                            ? Math.hypot(now.x(i) - state[i][0], now.y(i) - state[i][1])
                            : Double.POSITIVE_INFINITY);
        }
        return worst;
    }

    /** The largest difference of a body's velocity from its true one, length / time; NaN where no velocity is known. */
    double velocityError(WorldSnapshot now) {
        double worst = Double.NaN;
        for (int i = 0; i < state.length; i++) {
            double error = now.count() == state.length
                    ? Math.hypot(now.vx(i) - state[i][2], now.vy(i) - state[i][3])
                    : Double.POSITIVE_INFINITY;
            worst = Double.isNaN(worst) || error > worst ? error : worst;
        }
        return worst;
    }
}

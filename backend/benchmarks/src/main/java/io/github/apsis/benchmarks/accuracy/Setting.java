package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.reference.Fraction;

/**
 * A method and how fine it is.
 *
 * @param dt tick, time
 * @param tolerance relative local error, of the adaptive method alone; NaN for a fixed step
 */
public record Setting(Method method, double dt, double tolerance) {
    static Setting fixed(Method method, double dt) {
        return new Setting(method, dt, Double.NaN);
    }

    static Setting adaptive(double dt, double tolerance) {
        return new Setting(Method.ADAPTIVE, dt, tolerance);
    }

    @Override
    public String toString() {
        return method == Method.ADAPTIVE
                ? "adaptive %.0e, dt %s".formatted(tolerance, Fraction.format(dt))
                : method.label() + ", dt " + Fraction.format(dt);
    }
}

package io.github.apsis.engine.math;

/** A point or a vector, for the edges of the engine; its loops use columns. */
public record Vec2(double x, double y) {
    public double length() {
        return Math.sqrt(x * x + y * y);
    }
}

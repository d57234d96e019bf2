package io.github.apsis.engine.body;

/** Names one body for the life of its world; never reused. Positive. */
public record BodyId(long value) {
    public BodyId {
        if (value <= 0) {
            throw new IllegalArgumentException("a body id must be positive, was " + value);
        }
    }
}

package io.github.apsis.engine;

import io.github.apsis.engine.body.BodyId;

/**
 * A body that left the world of itself, because it was on its way out of the numbers. The others stay.
 *
 * @param tick after which it was gone
 */
public record Departure(BodyId body, long tick, Reason reason) {
    /** What was too much. */
    public enum Reason {
        /** A coordinate of 1e300 or more. */
        TOO_FAR,
        /** A speed of 1e150 or more. */
        TOO_FAST
    }
}

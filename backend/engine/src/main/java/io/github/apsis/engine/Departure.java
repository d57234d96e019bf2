package io.github.apsis.engine;

import io.github.apsis.engine.body.BodyId;
import java.util.Optional;

/**
 * A body that left the world of itself: on its way out of the numbers, or as a mortal ship that ran into something. The others stay.
 *
 * @param tick after which it was gone
 * @param with what a ship ran into; empty for all other reasons
 */
public record Departure(BodyId body, long tick, Reason reason, Optional<BodyId> with) {
    /** One that ran into nothing. */
    public Departure(BodyId body, long tick, Reason reason) {
        this(body, tick, reason, Optional.empty());
    }

    /** Why it left. */
    public enum Reason {
        /** A coordinate of 1e300 or more. */
        TOO_FAR,
        /** A speed of 1e150 or more. */
        TOO_FAST,
        /** A mortal ship bounced off another body: see {@link WorldSpec.Builder#mortalShips}. */
        COLLIDED
    }
}

package io.github.apsis.server.room;

import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.BodyKind;
import java.util.Optional;

/**
 * Something that happened to a ship. Immutable.
 *
 * @param number 1, 2, 3 … in its room
 * @param tick after which it had happened
 * @param time of that tick, simulated
 * @param encounter empty where it has arrived
 */
public record ShipEvent(long number, long tick, double time, What what, BodyId ship, Optional<Encounter> encounter) {
    /**
     * What the ship ran into, which may be gone by now.
     *
     * @param closingSpeed along the line of centres just before, length / time
     */
    public record Encounter(BodyId other, BodyKind kind, double closingSpeed) {}

    /** What can happen to a ship. */
    public enum What {
        ARRIVED,
        COLLIDED,
        DESTROYED
    }
}

package io.github.apsis.server.room;

import io.github.apsis.engine.body.BodyId;
import java.util.List;

/** What became of a request. */
public sealed interface Outcome {
    /**
     * Done.
     *
     * @param bodies that were added, selected, removed or sent off
     * @param tick the first tick that sees the change
     */
    record Done(List<BodyId> bodies, long tick) implements Outcome {}

    /** Not done, and nothing changed. */
    record Refused(Reason reason) implements Outcome {}

    /** Why a request could not be done. */
    enum Reason {
        NO_SUCH_BODY,
        NO_SHIP_SELECTED,
        OUTSIDE_WORLD,
        /** The room holds its maximum of bodies. */
        WORLD_FULL,
        /** No free place for one more body. */
        NO_ROOM,
        /** The command queue is full, or the room is closing. */
        ROOM_BUSY
    }
}

package io.github.apsis.engine;

import io.github.apsis.engine.body.BodyId;

/** What became of a command. */
public sealed interface CommandResult {
    /** Done; {@code body} is the one that was added, removed or ordered. */
    record Accepted(BodyId body) implements CommandResult {}

    /** Not done, and nothing changed. */
    record Rejected(Reason reason) implements CommandResult {}

    /** Why a command could not be done. */
    enum Reason {
        NO_SUCH_BODY,
        NOT_A_SHIP,
        OUTSIDE_WORLD,
        WORLD_FULL
    }
}

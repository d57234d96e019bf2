package io.github.apsis.protocol;

import org.jspecify.annotations.Nullable;

/** What a client may ask of a room. */
public sealed interface ClientMessage {
    /** Adds a random body of this kind, or of any kind when there is none. Travels without a body. */
    record Add(@Nullable Kind kind) implements ClientMessage {}

    /** Selects or deselects a body, for this client alone. */
    record Select(long id, boolean selected) implements ClientMessage {}

    /** Removes a body. */
    record Delete(long id) implements ClientMessage {}

    /** Sends the selected ships to a point, where they stop. */
    record Move(double x, double y) implements ClientMessage {}
}

package io.github.apsis.protocol;

import org.jspecify.annotations.Nullable;

/**
 * Why a request was refused: a code for programs, a sentence for people.
 *
 * @param field the offending field, where there is one
 */
public record Problem(Code code, String message, @Nullable String field) {
    public Problem(Code code, String message) {
        this(code, message, null);
    }

    /** The reasons of the treaty. */
    public enum Code {
        MALFORMED_JSON,
        MISSING_FIELD,
        INVALID_VALUE,
        NO_SUCH_BODY,
        NO_SHIP_SELECTED,
        OUTSIDE_WORLD,
        WORLD_FULL,
        NO_ROOM,
        UNKNOWN_DESTINATION,
        TOO_MANY_COMMANDS,
        ROOM_BUSY,
        MESSAGE_TOO_LARGE,
        MALFORMED_FRAME
    }
}

package io.github.apsis.protocol;

import java.util.List;
import java.util.Locale;
import org.jspecify.annotations.Nullable;

/**
 * What happened to ships: the newest events of a room, the oldest first.
 *
 * @param unlisted events that came too fast to be listed, since the room opened
 */
public record Events(long tick, long unlisted, List<Event> events) {
    /**
     * One event.
     *
     * @param number 1, 2, 3 … in this room, without gaps among those that are listed
     * @param other what it ran into; null where it has arrived
     * @param speed with which they closed; null where it has arrived
     */
    public record Event(
            long number, long tick, double time, Type type, long ship, @Nullable Other other, @Nullable Double speed) {}

    /** The body that a ship ran into; it may be gone by now. */
    public record Other(long id, Kind kind) {}

    /** What happened. Travels in lower case. */
    public enum Type {
        /** A ship has come to rest where it was ordered to. */
        ARRIVED,
        /** A ship has run into another body, and goes on. */
        COLLIDED,
        /** A ship has run into another body, and is gone. */
        DESTROYED;

        private final String wireName = name().toLowerCase(Locale.ROOT);

        @Override
        public String toString() {
            return wireName;
        }
    }
}

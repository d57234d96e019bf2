package io.github.apsis.server.room;

import java.util.List;

/**
 * The newest events of a room, the oldest first. Whoever takes the newest of these misses none, unless more than
 * {@link EventLog#LISTED} happen before he looks again. Immutable.
 *
 * @param unlisted events that came too fast to be listed, since the room opened
 */
public record ShipEvents(long tick, long unlisted, List<ShipEvent> events) {}

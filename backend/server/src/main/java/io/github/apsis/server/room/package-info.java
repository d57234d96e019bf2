/**
 * Rooms on a clock, in plain Java: a {@link io.github.apsis.server.room.Room} is a world, its command queue, its
 * selections and its sink; a {@link io.github.apsis.server.room.TickLoop} ticks it. Knows nothing of Spring or of the
 * wire.
 */
@NullMarked
package io.github.apsis.server.room;

import org.jspecify.annotations.NullMarked;

package io.github.apsis.server.room;

import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.body.BodyId;
import java.util.Map;
import java.util.Set;

/**
 * All bodies of a room after one tick. Immutable.
 *
 * @param appearances of the bodies that look like more than their circle
 * @param selected the bodies that anyone has selected
 * @param speed of the room's clock, as a share of real time
 */
public record RoomFrame(WorldSnapshot world, Map<BodyId, Appearance> appearances, Set<BodyId> selected, double speed) {}

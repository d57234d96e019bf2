package io.github.apsis.server.room;

/**
 * How the ships of a room have fared since it opened.
 *
 * @param collisions with other bodies, a meeting of two ships once
 * @param shipTicks Σ ships over all ticks
 */
public record ShipTally(long collisions, long shipTicks) {
    private static final double TICKS_PER_MINUTE = 60.0 * TickLoop.TICKS_PER_SECOND;

    /** The time that all ships together have flown, in minutes of the room's clock. */
    public double shipMinutes() {
        return shipTicks / TICKS_PER_MINUTE;
    }

    /** Collisions per ship-minute; 0 before any ship has flown. */
    public double collisionsPerShipMinute() {
        return shipTicks == 0 ? 0 : collisions / shipMinutes();
    }
}

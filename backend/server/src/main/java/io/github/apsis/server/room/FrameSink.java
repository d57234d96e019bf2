package io.github.apsis.server.room;

/**
 * Where a room's moments go. Called on the room's tick thread: returns at once, never blocks and never throws. What it
 * is given is immutable.
 */
public interface FrameSink {
    /** The bodies, at the frame rate of the room. */
    void publish(RoomFrame frame);

    /** What the ships are doing that somebody has selected, ten times a second; not at all where nobody has. */
    void publish(WatchedShips ships);

    /** What happened to ships, five times a second at most, and only when something has. */
    void publish(ShipEvents events);

    /** How the room is doing, four times a second. */
    void publish(RoomReadings readings);
}

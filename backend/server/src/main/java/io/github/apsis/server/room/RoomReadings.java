package io.github.apsis.server.room;

import java.util.Optional;

/**
 * How a room is doing. Immutable.
 *
 * @param time simulated
 * @param conservation empty where the scene does not ask for it, or the room holds too many bodies to measure it in a
 * tick
 */
public record RoomReadings(long tick, double time, Pace pace, int bodies, Optional<Conservation> conservation) {}

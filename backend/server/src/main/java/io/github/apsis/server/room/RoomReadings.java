package io.github.apsis.server.room;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * How a room is doing. Immutable.
 *
 * @param time simulated
 * @param gravitySolver what sums the attraction up: {@code direct}, {@code tree, opening 0.55}, {@code nearest image}, or {@code none}
 * @param forceError of that solver, which nine of ten sampled bodies keep; empty where none is allowed
 * @param conservation empty where the scene does not ask for it, or the room holds too many bodies to measure it in a
 * tick
 */
public record RoomReadings(
        long tick,
        double time,
        Pace pace,
        int bodies,
        String gravitySolver,
        OptionalDouble forceError,
        Optional<Conservation> conservation) {}

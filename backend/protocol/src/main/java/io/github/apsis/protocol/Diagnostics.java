package io.github.apsis.protocol;

import org.jspecify.annotations.Nullable;

/**
 * How a room is doing. What was not measured travels as {@code null}.
 *
 * @param ticksPerSecond over the last second
 * @param lateTicks began more than half a period late, since the room opened
 * @param droppedTicks given up, since the room opened
 * @param energyDrift relative change since the bodies were last changed
 * @param momentumDrift change relative to Σ|m·v|
 */
public record Diagnostics(
        long tick,
        double time,
        double ticksPerSecond,
        TickMillis tickMillis,
        long lateTicks,
        long droppedTicks,
        int bodies,
        int clients,
        @Nullable Double energy,
        @Nullable Double energyDrift,
        @Nullable Point momentum,
        @Nullable Double momentumDrift) {

    /** How long ticks took in the last ten seconds, milliseconds. */
    public record TickMillis(double p50, double p99) {}
}

package io.github.apsis.protocol;

import org.jspecify.annotations.Nullable;

/**
 * How a room is doing. What was not measured travels as {@code null}.
 *
 * @param ticksPerSecond over the last second
 * @param lateTicks began more than half a period late, since the room opened
 * @param droppedTicks given up, since the room opened
 * @param speed of the room's clock, as a share of real time: 1, or less where the room is too heavy
 * @param kinetic energy
 * @param potential energy
 * @param energyDrift relative change since the bodies were last changed
 * @param momentumDrift change relative to Σ|m·v|
 * @param angularMomentum about the origin
 * @param angularMomentumDrift change relative to Σ|m·r||v|
 * @param virialRatio 2 · kinetic / |potential|
 * @param gravitySolver {@code direct}, or {@code none} in a scene without attraction
 * @param forceError of the gravity solver, relative; null where it is exact
 */
public record Diagnostics(
        long tick,
        double time,
        double ticksPerSecond,
        TickMillis tickMillis,
        long lateTicks,
        long droppedTicks,
        double speed,
        int bodies,
        int clients,
        @Nullable Double kinetic,
        @Nullable Double potential,
        @Nullable Double energy,
        @Nullable Double energyDrift,
        @Nullable Point momentum,
        @Nullable Double momentumDrift,
        @Nullable Double angularMomentum,
        @Nullable Double angularMomentumDrift,
        @Nullable Double centreOfMassX,
        @Nullable Double centreOfMassY,
        @Nullable Double virialRatio,
        String gravitySolver,
        @Nullable Double forceError) {

    /** How long ticks took in the last ten seconds, milliseconds. */
    public record TickMillis(double p50, double p99) {}
}

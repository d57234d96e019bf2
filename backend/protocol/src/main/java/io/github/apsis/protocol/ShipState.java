package io.github.apsis.protocol;

import org.jspecify.annotations.Nullable;

/**
 * What the ship is doing that a client has selected last.
 *
 * @param target where it is ordered to; null while it wanders
 * @param course the velocity that it is on its way to
 * @param evading whether that is a detour for the sake of others
 * @param acceleration of its engine
 * @param threat what it would come too close to first if it did as it likes; null when there is nothing
 */
public record ShipState(
        long id,
        long tick,
        double time,
        @Nullable Point target,
        Point course,
        boolean evading,
        Point acceleration,
        @Nullable Threat threat) {

    /**
     * A body that is in the way.
     *
     * @param timeToContact or to the closest approach, as it was when the ship last thought
     * @param passing how the two will pass each other on the course that was chosen
     */
    public record Threat(long id, double timeToContact, Passing passing) {}

    /**
     * The closest approach of the ship on its course and a body that goes straight on.
     *
     * @param time from now
     * @param gap between the rims; negative where they would touch
     * @param ship where its centre will be
     * @param body where the centre of the other will be
     */
    public record Passing(double time, double gap, Point ship, Point body) {}
}

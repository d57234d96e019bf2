package io.github.apsis.server.room;

/**
 * How a tick loop is doing.
 *
 * @param ticksPerSecond over the last second
 * @param p50Millis half of the ticks of the last ten seconds were shorter
 * @param p99Millis all but one in a hundred were shorter
 * @param lateTicks began more than half a period late, since the room opened
 * @param droppedTicks given up because the loop was too far behind, since the room opened
 * @param speed of the room's clock, as a share of real time: 1, or less where the room is too heavy
 */
public record Pace(
        double ticksPerSecond, double p50Millis, double p99Millis, long lateTicks, long droppedTicks, double speed) {
    static final Pace AT_START = new Pace(0, 0, 0, 0, 0, 1);
}

package io.github.apsis.protocol;

import java.util.List;

/**
 * All bodies of a room at one moment. The bodies travel as a JSON array, tick and time as headers of the message.
 *
 * @param time simulated, in the time unit of the scene
 */
public record Frame(long tick, double time, List<BodyState> bodies) {}

package io.github.apsis.server.room;

import io.github.apsis.engine.ShipReading;
import java.util.Map;

/**
 * What the ships are doing that clients have selected last. A ship that several look at is the same object for all of them.
 * Immutable.
 */
public record WatchedShips(long tick, double time, Map<ClientId, ShipReading> byClient) {}

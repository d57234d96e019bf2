package io.github.apsis.server.room;

import io.github.apsis.engine.body.BodyId;
import io.github.apsis.server.room.ShipEvent.Encounter;
import io.github.apsis.server.room.ShipEvent.What;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/**
 * The last events of a room. A heap of ships may bounce hundreds of times a second: {@value #BURST} events are listed at once and
 * {@value #PER_SECOND} a second in the long run, by the room's clock; the others are counted. Belongs to the tick thread.
 */
final class EventLog {
    /** How many of the newest are kept: some seconds of the highest rate. */
    static final int LISTED = 20;

    static final int BURST = 10;
    static final int PER_SECOND = 5;

    private static final int TICKS_PER_EVENT = TickLoop.TICKS_PER_SECOND / PER_SECOND;

    private final Deque<ShipEvent> newest = new ArrayDeque<>();
    private long number;
    private long unlisted;
    private long spent = -(long) BURST * TICKS_PER_EVENT; // the tick up to which its share of events is used up
    private boolean changed;

    void add(long tick, double time, What what, BodyId ship, Optional<Encounter> encounter) {
        changed = true;
        long from = Math.max(spent, tick - (long) BURST * TICKS_PER_EVENT);
        if (from + TICKS_PER_EVENT > tick) {
            unlisted++;
            return;
        }
        spent = from + TICKS_PER_EVENT;
        if (newest.size() == LISTED) {
            newest.removeFirst();
        }
        newest.addLast(new ShipEvent(++number, tick, time, what, ship, encounter));
    }

    /** The newest events, if any has happened since this was asked last. */
    Optional<ShipEvents> news(long tick) {
        if (!changed) {
            return Optional.empty();
        }
        changed = false;
        return Optional.of(new ShipEvents(tick, unlisted, List.copyOf(newest)));
    }
}

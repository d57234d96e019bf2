package io.github.apsis.engine;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * Who has left a world of themselves: the last of them by name, all others by number, so that a world in which ships run into
 * rocks for a year does not grow.
 */
final class Departures {
    private static final int KEPT = 1000;

    private final List<Departure> last = new ArrayList<>();
    private long count;

    /** Forgets the oldest beyond those that are kept, before a tick adds its own: who asks after every tick misses nobody. */
    void beginTick() {
        if (last.size() > KEPT) {
            last.subList(0, last.size() - KEPT).clear();
        }
    }

    void add(Departure departure) {
        last.add(departure);
        count++;
    }

    /** How many there have been. */
    long count() {
        return count;
    }

    /** Those that are kept, in the order in which they left. */
    List<Departure> last() {
        return Collections.unmodifiableList(last);
    }

    /** Those that are kept and were not among the first so many. */
    List<Departure> since(long known) {
        int news = (int) Math.max(0, Math.min(count - known, last.size()));
        return news == 0 ? List.of() : List.copyOf(last.subList(last.size() - news, last.size()));
    }
}

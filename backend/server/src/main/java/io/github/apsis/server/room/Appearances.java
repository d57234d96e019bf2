package io.github.apsis.server.room;

import io.github.apsis.engine.body.BodyId;
import java.util.HashMap;
import java.util.Map;

/**
 * The looks of a room's bodies. Belongs to the tick thread; what it hands out is an immutable copy, made after a
 * change.
 */
final class Appearances {
    private final Map<BodyId, Appearance> current = new HashMap<>();
    private Map<BodyId, Appearance> handedOut = Map.of();
    private boolean changed;

    void put(BodyId body, Appearance appearance) {
        current.put(body, appearance);
        changed = true;
    }

    void forget(BodyId body) {
        changed |= current.remove(body) != null;
    }

    Map<BodyId, Appearance> copy() {
        if (changed) {
            handedOut = Map.copyOf(current);
            changed = false;
        }
        return handedOut;
    }
}

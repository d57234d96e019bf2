package io.github.apsis.server.room;

import io.github.apsis.engine.body.BodyId;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;

/**
 * Who has selected what: each client for itself, so two people do not fight over a body. Belongs to the tick thread.
 */
final class Selections {
    private final Map<ClientId, Set<BodyId>> byClient = new HashMap<>();
    private Set<BodyId> handedOut = Set.of();
    private boolean changed;

    void select(ClientId client, BodyId body) {
        changed |=
                byClient.computeIfAbsent(client, who -> new LinkedHashSet<>()).add(body);
    }

    void deselect(ClientId client, BodyId body) {
        changed |= byClient.getOrDefault(client, Set.of()).remove(body);
    }

    /** What this client has selected, in the order of selection. */
    Set<BodyId> of(ClientId client) {
        return byClient.getOrDefault(client, Set.of());
    }

    /** The body is gone: nobody has it selected any more. */
    void forget(BodyId body) {
        for (Set<BodyId> selected : byClient.values()) {
            changed |= selected.remove(body);
        }
    }

    /** The client is gone. */
    void leave(ClientId client) {
        changed |= byClient.remove(client) != null;
    }

    /** What anyone has selected: an immutable copy, made after a change. */
    Set<BodyId> ofAnyone() {
        if (changed) {
            Set<BodyId> all = new HashSet<>();
            byClient.values().forEach(all::addAll);
            handedOut = Set.copyOf(all);
            changed = false;
        }
        return handedOut;
    }
}

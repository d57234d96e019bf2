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
    private final Map<ClientId, BodyId> last = new HashMap<>();
    private Set<BodyId> handedOut = Set.of();
    private boolean changed;

    /** What is selected again counts as selected last. */
    void select(ClientId client, BodyId body) {
        Set<BodyId> selected = byClient.computeIfAbsent(client, who -> new LinkedHashSet<>());
        boolean isNew = !selected.remove(body);
        selected.add(body);
        changed |= isNew;
        last.put(client, body);
    }

    void deselect(ClientId client, BodyId body) {
        if (byClient.getOrDefault(client, Set.of()).remove(body)) {
            changed = true;
            findLast(client, body);
        }
    }

    private void findLast(ClientId client, BodyId gone) {
        if (gone.equals(last.get(client))) {
            last.remove(client);
            // In the order of selection, so the last one stays.
            byClient.getOrDefault(client, Set.of()).forEach(body -> last.put(client, body));
        }
    }

    /** What each client has selected last. Not to be changed. */
    Map<ClientId, BodyId> last() {
        return last;
    }

    /** What this client has selected, in the order of selection. */
    Set<BodyId> of(ClientId client) {
        return byClient.getOrDefault(client, Set.of());
    }

    /** The body is gone: nobody has it selected any more. */
    void forget(BodyId body) {
        byClient.keySet().forEach(client -> deselect(client, body));
    }

    /** The client is gone. */
    void leave(ClientId client) {
        changed |= byClient.remove(client) != null;
        last.remove(client);
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

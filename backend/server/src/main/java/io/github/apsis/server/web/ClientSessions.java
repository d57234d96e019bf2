package io.github.apsis.server.web;

import jakarta.annotation.PreDestroy;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.LongAdder;
import org.jspecify.annotations.Nullable;
import org.springframework.scheduling.concurrent.CustomizableThreadFactory;
import org.springframework.stereotype.Component;
import org.springframework.web.socket.WebSocketSession;

/** All clients of this node. May be used from any thread. */
@Component
class ClientSessions {
    private final ApsisProperties.Limits limits;
    private final LongAdder conflated = new LongAdder();
    private final Map<String, ClientSession> byId = new ConcurrentHashMap<>();

    /** At most one task per session, so the limit of sessions bounds the threads; idle ones end after a minute. */
    private final ExecutorService senders;

    ClientSessions(ApsisProperties properties) {
        this.limits = properties.limits();
        CustomizableThreadFactory threads = new CustomizableThreadFactory("send-");
        threads.setDaemon(true);
        this.senders = Executors.newCachedThreadPool(threads);
    }

    ClientSession open(WebSocketSession socket) {
        ClientSession session = new ClientSession(socket, senders, conflated, limits);
        byId.put(session.getId(), session);
        return session;
    }

    void forget(String id) {
        byId.remove(id);
    }

    @Nullable
    ClientSession byId(@Nullable String id) {
        return id == null ? null : byId.get(id);
    }

    int count() {
        return byId.size();
    }

    boolean isFull() {
        return count() >= limits.sessions();
    }

    boolean anySubscribed(String topic) {
        return byId.values().stream().anyMatch(session -> session.isSubscribed(topic));
    }

    void publish(Bulletin bulletin) {
        byId.values().forEach(session -> session.offer(bulletin));
    }

    /** Stream messages that were never sent because a newer one came first. */
    long conflated() {
        return conflated.sum();
    }

    @PreDestroy
    void stop() {
        senders.shutdown();
    }
}

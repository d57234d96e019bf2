package io.github.apsis.server.web;

import io.github.bucket4j.Bucket;
import java.io.IOException;
import java.time.Duration;
import java.util.Map;
import java.util.Queue;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.LongAdder;
import lombok.extern.slf4j.Slf4j;
import org.jspecify.annotations.Nullable;
import org.springframework.web.socket.CloseStatus;
import org.springframework.web.socket.TextMessage;
import org.springframework.web.socket.WebSocketMessage;
import org.springframework.web.socket.WebSocketSession;
import org.springframework.web.socket.adapter.NativeWebSocketSession;
import org.springframework.web.socket.handler.WebSocketSessionDecorator;
import org.springframework.web.socket.sockjs.transport.session.AbstractHttpSockJsSession;

/**
 * The way out to one client, below STOMP. Nothing here blocks its caller: control messages wait in a queue, of a stream
 * only the newest message waits in its {@link Slot}, and one task at a time sends them. So a client that stops reading
 * costs one waiting thread until its send times out, and nobody else notices.
 *
 * <p>May be used from any thread.
 */
@Slf4j
final class ClientSession extends WebSocketSessionDecorator {
    /** More unsent answers than ten seconds of commands can cause: this client does not read. */
    private static final int MOST_WAITING = 2000;

    private static final int MOST_SUBSCRIPTIONS = 20;
    private static final int MOST_COMPLAINTS_PER_SECOND = 10;

    private final Executor senders;
    private final LongAdder conflated;
    private final Bucket commands;
    private final Bucket complaints = bucket(MOST_COMPLAINTS_PER_SECOND, MOST_COMPLAINTS_PER_SECOND);
    private final Queue<Sending> control = new ConcurrentLinkedQueue<>();
    private final AtomicInteger waiting = new AtomicInteger();
    private final Map<String, Slot> slots = new ConcurrentHashMap<>();
    private final AtomicBoolean sending = new AtomicBoolean();
    private volatile boolean welcomed;
    private volatile boolean closing;

    /** One thing to do with the socket. */
    private interface Sending {
        void through(WebSocketSession socket) throws IOException;
    }

    ClientSession(WebSocketSession socket, Executor senders, LongAdder conflated, ApsisProperties.Limits limits) {
        super(socket);
        this.senders = senders;
        this.conflated = conflated;
        this.commands = bucket(limits.commandBurst(), limits.commandsPerSecond());
    }

    private static Bucket bucket(long burst, long perSecond) {
        return Bucket.builder()
                .addLimit(limit -> limit.capacity(burst).refillGreedy(perSecond, Duration.ofSeconds(1)))
                .build();
    }

    /** Whether the client may send one more command now. */
    boolean mayCommand() {
        return commands.tryConsume(1);
    }

    /** Whether it may be told once more that it sends too much: a flood must not be answered by a flood. */
    boolean mayBeTold() {
        return complaints.tryConsume(1);
    }

    /** Whether its end has been decided: nothing that still comes in counts. */
    boolean isClosing() {
        return closing;
    }

    /** Whether there was a place for one more subscription to a stream. */
    boolean subscribe(String subscription, String topic) {
        if (slots.size() >= MOST_SUBSCRIPTIONS && !slots.containsKey(subscription)) {
            return false;
        }
        if (!closing) {
            slots.put(subscription, new Slot(topic, subscription));
        }
        return true;
    }

    void unsubscribe(String subscription) {
        slots.remove(subscription);
    }

    boolean isSubscribed(String topic) {
        return slots.values().stream().anyMatch(slot -> slot.isOf(topic));
    }

    /** Sends it to the subscriptions of its topic, in place of what they have not been sent yet. */
    void offer(Bulletin bulletin) {
        for (Slot slot : slots.values()) {
            if (slot.isOf(bulletin.topic()) && slot.replace(bulletin)) {
                conflated.increment();
            }
        }
        wake();
    }

    @Override
    public void sendMessage(WebSocketMessage<?> message) {
        if (message instanceof TextMessage text && text.getPayload().startsWith("CONNECTED")) {
            enqueue(socket -> {
                socket.sendMessage(message);
                welcomed = true; // no frame before the welcome
            });
        } else {
            enqueue(socket -> socket.sendMessage(message));
        }
    }

    @Override
    public void close() {
        close(CloseStatus.NORMAL);
    }

    /** Closes when all that waits has been sent: an error must arrive before its session ends. */
    @Override
    public void close(CloseStatus status) {
        closing = true;
        slots.clear();
        enqueue(socket -> socket.close(status));
    }

    private void enqueue(Sending one) {
        if (waiting.incrementAndGet() > MOST_WAITING) {
            waiting.decrementAndGet();
            return;
        }
        control.add(one);
        wake();
    }

    private void wake() {
        if (hasWork() && sending.compareAndSet(false, true)) {
            senders.execute(this::sendAll);
        }
    }

    private boolean hasWork() {
        return !control.isEmpty() || (takesFrames() && slots.values().stream().anyMatch(slot -> !slot.isEmpty()));
    }

    private void sendAll() {
        try {
            while (sendControl() || sendNewest()) {
                // until nothing waits
            }
        } catch (IOException | RuntimeException e) {
            giveUp(e);
        } finally {
            sending.set(false);
        }
        wake(); // what came in between
    }

    private boolean sendControl() throws IOException {
        Sending one = control.poll();
        if (one == null) {
            return false;
        }
        waiting.decrementAndGet();
        one.through(getDelegate());
        return true;
    }

    private boolean sendNewest() throws IOException {
        boolean any = false;
        for (Slot slot : slots.values()) {
            String message = takesFrames() ? slot.take() : null;
            if (message != null) {
                getDelegate().sendMessage(new TextMessage(message));
                any = true;
            }
        }
        return any;
    }

    /** A SockJS client between two polls would be sent old frames later: its slots keep the newest until it asks. */
    private boolean takesFrames() {
        return welcomed && (!(getDelegate() instanceof AbstractHttpSockJsSession http) || http.isActive());
    }

    private void giveUp(Exception reason) {
        log.debug("session {} does not take its messages, closing: {}", getId(), reason.toString());
        slots.clear();
        control.clear();
        waiting.set(0);
        try {
            getDelegate().close(CloseStatus.SESSION_NOT_RELIABLE);
        } catch (IOException | RuntimeException e) {
            log.debug("session {} was closed already: {}", getId(), e.toString());
        }
    }

    /** The session of the container, for its settings; null for SockJS without a WebSocket. */
    <T> @Nullable T nativeSession(Class<T> type) {
        return getDelegate() instanceof NativeWebSocketSession socket ? socket.getNativeSession(type) : null;
    }
}

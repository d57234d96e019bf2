package io.github.apsis.server.web;

import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;

/** One subscription to a stream, and the newest message that it has not been sent yet. */
final class Slot {
    private final String topic;
    private final String subscription; // as it stands in a STOMP header
    private final AtomicReference<@Nullable Bulletin> newest = new AtomicReference<>();
    private long sent; // touched by the drain alone

    Slot(String topic, String subscription) {
        this.topic = topic;
        this.subscription = escape(subscription);
    }

    boolean isOf(String destination) {
        return topic.equals(destination);
    }

    /** Puts in what is to be sent next, and says whether it took the place of something older. Any thread. */
    boolean replace(Bulletin bulletin) {
        return newest.getAndSet(bulletin) != null;
    }

    boolean isEmpty() {
        return newest.get() == null;
    }

    /** The newest message, ready for the wire; null when it was sent already. */
    @Nullable
    String take() {
        Bulletin bulletin = newest.getAndSet(null);
        return bulletin == null ? null : bulletin.toStomp(subscription, subscription + "-" + sent++);
    }

    private static String escape(String header) {
        return header.replace("\\", "\\\\")
                .replace("\n", "\\n")
                .replace("\r", "\\r")
                .replace(":", "\\c");
    }
}

package io.github.apsis.server.room;

import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;

/**
 * A bounded queue from many threads to one. Nobody ever waits: a full queue refuses, an empty one has nothing.
 *
 * @param <T> what waits in it
 */
final class CommandQueue<T> {
    private final int capacity;
    private final Queue<T> waiting = new ConcurrentLinkedQueue<>();
    private final AtomicInteger size = new AtomicInteger();

    CommandQueue(int capacity) {
        this.capacity = capacity;
    }

    /** Whether there was a place for it. Any thread. */
    boolean offer(T command) {
        if (size.incrementAndGet() > capacity) {
            size.decrementAndGet();
            return false;
        }
        waiting.add(command);
        return true;
    }

    /** Takes it even when the queue is full: for what must not be lost and cannot come often. Any thread. */
    void force(T command) {
        size.incrementAndGet();
        waiting.add(command);
    }

    /** Hands over what waits, in order of arrival, but no more than {@code most}. One thread at a time. */
    void drain(int most, Consumer<? super T> consumer) {
        for (int n = 0; n < most; n++) {
            T command = waiting.poll();
            if (command == null) {
                return;
            }
            size.decrementAndGet();
            consumer.accept(command);
        }
    }
}

package io.github.apsis.server.room;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import java.util.stream.IntStream;

/**
 * All rooms of this server, by id. A room stays on one thread for its life, a thread may carry many rooms. May be used
 * from any thread.
 */
public final class Rooms implements AutoCloseable {
    private final LongSupplier nanoTime;
    private final Map<String, OpenRoom> open = new ConcurrentHashMap<>();
    private final List<ScheduledExecutorService> threads;
    private final AtomicInteger nextThread = new AtomicInteger();
    private final AtomicLong failures = new AtomicLong();

    public Rooms() {
        this(Runtime.getRuntime().availableProcessors(), System::nanoTime);
    }

    Rooms(int threadCount, LongSupplier nanoTime) {
        this.nanoTime = nanoTime;
        this.threads =
                IntStream.range(0, threadCount).mapToObj(Rooms::tickThread).toList();
    }

    private static ScheduledExecutorService tickThread(int number) {
        return Executors.newSingleThreadScheduledExecutor(run -> {
            Thread thread = new Thread(run, "tick-" + number);
            thread.setDaemon(true);
            return thread;
        });
    }

    /** Opens a room whose frames go to the sink. Its clock stands still until {@link OpenRoom#start}. */
    public OpenRoom open(RoomSpec spec, FrameSink sink) {
        ScheduledExecutorService thread = threads.get(nextThread.getAndIncrement() % threads.size());
        OpenRoom room = new OpenRoom(spec, sink, thread, nanoTime, failures::incrementAndGet);
        if (open.putIfAbsent(spec.id(), room) != null) {
            throw new IllegalStateException("there is a room " + spec.id() + " already");
        }
        return room;
    }

    public Optional<OpenRoom> byId(String id) {
        return Optional.ofNullable(open.get(id));
    }

    public Collection<OpenRoom> all() {
        return open.values();
    }

    /** The client is gone, from every room. */
    public void leave(ClientId client) {
        open.values().forEach(room -> room.leave(client));
    }

    /** Rooms that have thrown and were replaced, since the server began. */
    public long failures() {
        return failures.get();
    }

    @Override
    public void close() {
        open.values().forEach(OpenRoom::close);
        threads.forEach(ScheduledExecutorService::shutdownNow);
    }
}

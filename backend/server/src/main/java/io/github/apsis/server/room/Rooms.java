package io.github.apsis.server.room;

import java.lang.management.ManagementFactory;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.LongSupplier;
import java.util.stream.IntStream;

/**
 * All rooms of this server, by id. A room stays on one thread for its life, a thread may carry many rooms. A room that would
 * need more than is left of the least busy thread is refused. May be used from any thread.
 */
public final class Rooms implements AutoCloseable {
    private final LongSupplier nanoTime;
    private final Map<String, OpenRoom> open = new ConcurrentHashMap<>();
    private final List<TickThread> threads;
    private final double mostLoad;
    private final AtomicLong failures = new AtomicLong();

    /**
     * A thread for each processor.
     *
     * @param mostLoad the share of a thread that the rooms on it may be expected to need when one is opened
     */
    public Rooms(double mostLoad) {
        this(
                mostLoad,
                IntStream.range(0, Runtime.getRuntime().availableProcessors())
                        .mapToObj(Rooms::tickThread)
                        .toList(),
                System::nanoTime,
                ManagementFactory.getThreadMXBean()::getCurrentThreadCpuTime);
    }

    Rooms(
            double mostLoad,
            List<? extends ScheduledExecutorService> executors,
            LongSupplier nanoTime,
            LongSupplier cpuTime) {
        this.mostLoad = mostLoad;
        this.nanoTime = nanoTime;
        this.threads = executors.stream()
                .map(executor -> new TickThread(executor, cpuTime))
                .toList();
    }

    private static ScheduledExecutorService tickThread(int number) {
        return Executors.newSingleThreadScheduledExecutor(run -> {
            Thread thread = new Thread(run, "tick-" + number);
            thread.setDaemon(true);
            return thread;
        });
    }

    /**
     * Opens a room whose frames go to the sink, on the thread that has most time left. Its clock stands still until
     * {@link OpenRoom#start}.
     *
     * @param load what the room is expected to need, as {@link WarmUp} measures it; from then on what it does need counts
     */
    public synchronized Admission open(RoomSpec spec, double load, FrameSink sink) {
        if (open.containsKey(spec.id())) {
            throw new IllegalStateException("there is a room " + spec.id() + " already");
        }
        TickThread thread = threads.stream()
                .min(Comparator.comparingDouble(TickThread::load))
                .orElseThrow();
        if (!(thread.load() + load <= mostLoad)) {
            return new Admission.Refused(refusal(spec, load, Math.max(0, mostLoad - thread.load())));
        }
        thread.needs(spec.id(), load);
        OpenRoom room = new OpenRoom(spec, sink, thread, nanoTime, failures::incrementAndGet);
        open.put(spec.id(), room);
        return new Admission.Admitted(room);
    }

    private static String refusal(RoomSpec spec, double load, double left) {
        return String.format(
                Locale.ROOT,
                "There is no time for the room %s: with the scene %s it would take %.0f %% of a processor, and %.0f %% are left."
                        + " Choose a scene with fewer bodies, close another room, or raise apsis.limits.load and let clocks"
                        + " run slower than real time.",
                spec.id(),
                spec.scene().name(),
                Math.ceil(100 * load),
                Math.floor(100 * left));
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
        threads.forEach(thread -> thread.executor().shutdownNow());
    }
}

package io.github.apsis.server.room;

import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ScheduledExecutorService;
import java.util.function.LongSupplier;

/**
 * One thread that ticks rooms, and how its time is shared.
 *
 * <p>A room's load is the share of the thread that 150 ticks a second take. As long as all loads fit into {@link #MOST} every
 * clock runs at real time. When they do not, time is shared fairly (max-min): whoever needs less than an equal share has all
 * that it needs, and the others have the same each and run their clocks slower. dt is never touched.
 */
final class TickThread {
    /** The rest is for frames, and for ticks that take longer than the others. */
    static final double MOST = 0.9;

    private final ScheduledExecutorService executor;
    private final LongSupplier cpuTime;
    private final Map<String, Double> loads = new ConcurrentHashMap<>();

    /** {@code cpuTime} of the thread that asks, ns. */
    TickThread(ScheduledExecutorService executor, LongSupplier cpuTime) {
        this.executor = executor;
        this.cpuTime = cpuTime;
    }

    ScheduledExecutorService executor() {
        return executor;
    }

    /** That this thread has had so far, when it asks. */
    long cpuNanos() {
        return cpuTime.getAsLong();
    }

    /** What a room needs now. Any thread. */
    void needs(String room, double load) {
        loads.put(room, load);
    }

    void forget(String room) {
        loads.remove(room);
    }

    /** Of all rooms together. Any thread. */
    double load() {
        return loads.values().stream().mapToDouble(Double::doubleValue).sum();
    }

    /** What a room needs; 0 before anybody said. Any thread. */
    double load(String room) {
        return loads.getOrDefault(room, 0.0);
    }

    /** The share of real time at which the clock of a room can run. */
    double speed(String room) {
        double load = load(room);
        double share = fairShare();
        return load <= share ? 1 : share / load;
    }

    private double fairShare() {
        double[] ascending = loads.values().stream()
                .mapToDouble(Double::doubleValue)
                .sorted()
                .toArray();
        double left = MOST;
        for (int i = 0; i < ascending.length; i++) {
            double equal = left / (ascending.length - i);
            if (ascending[i] > equal) {
                return equal;
            }
            left -= ascending[i];
        }
        return Double.POSITIVE_INFINITY;
    }
}

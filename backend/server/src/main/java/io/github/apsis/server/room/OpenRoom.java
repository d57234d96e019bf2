package io.github.apsis.server.room;

import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import lombok.extern.slf4j.Slf4j;

/**
 * A room under its id, on its clock. When the room throws it is closed, logged once, and replaced by a fresh one of the
 * same scene: whoever holds this object does not notice more than a world that begins again. May be used from any
 * thread.
 */
@Slf4j
public final class OpenRoom {
    /** A room that fails at once would otherwise be rebuilt in a tight loop. */
    private static final long REOPEN_AFTER_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final RoomSpec spec;
    private final FrameSink sink;
    private final TickThread thread;
    private final LongSupplier nanoTime;
    private final Runnable onFailure;
    private volatile Life life;
    private volatile boolean closed;

    /** One world from its first tick to its end. */
    private record Life(Room room, TickMeter meter, TickLoop loop) {}

    OpenRoom(RoomSpec spec, FrameSink sink, TickThread thread, LongSupplier nanoTime, Runnable onFailure) {
        this.spec = spec;
        this.sink = sink;
        this.thread = thread;
        this.nanoTime = nanoTime;
        this.onFailure = onFailure;
        this.life = begin();
    }

    public RoomSpec spec() {
        return spec;
    }

    /**
     * Queues a request; {@code answer} is called once, on the tick thread or at once on this one, and must not block.
     */
    public void submit(ClientId client, Request request, Consumer<Outcome> answer) {
        life.room.submit(client, request, answer);
    }

    public int bodies() {
        return life.room.bodies();
    }

    /** How its ships have fared since it began. */
    public ShipTally ships() {
        return life.room.ships();
    }

    /** How the clock is doing. */
    public Pace pace() {
        return life.meter.latest();
    }

    /** The share of a thread that 150 ticks a second take. */
    public double load() {
        return thread.load(spec.id());
    }

    /** Nanoseconds since the last tick began. */
    public long nanosSinceLastTick() {
        return nanoTime.getAsLong() - life.meter.lastBegin();
    }

    void leave(ClientId client) {
        life.room.leave(client);
    }

    /** Starts the clock. */
    public void start() {
        life.loop.start();
    }

    void close() {
        closed = true;
        life.loop.stop();
        life.room.close();
        thread.forget(spec.id());
    }

    private Life begin() {
        long now = nanoTime.getAsLong();
        TickMeter meter = new TickMeter(now);
        ClockSpeed speed = new ClockSpeed(thread, spec.id(), now);
        Room room = new Room(spec, sink, meter::measure, speed::share);
        return new Life(
                room,
                meter,
                new TickLoop(thread.executor(), nanoTime, meter, speed, room::tick, e -> replace(room, e)));
    }

    private void replace(Room failed, Throwable reason) {
        log.error("room {} stopped at tick {} and begins again", spec.id(), failed.worldTick(), reason);
        onFailure.run();
        failed.close();
        try {
            thread.executor().schedule(this::beginAgain, REOPEN_AFTER_NANOS, TimeUnit.NANOSECONDS);
        } catch (RejectedExecutionException e) {
            log.debug("room {} stays closed: the server is going down", spec.id());
        }
    }

    private void beginAgain() {
        if (closed) {
            return;
        }
        try {
            life = begin();
            life.loop.start();
        } catch (RuntimeException e) {
            log.error("room {} cannot begin again", spec.id(), e);
        }
    }
}

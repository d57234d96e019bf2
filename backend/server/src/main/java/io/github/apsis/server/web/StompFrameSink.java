package io.github.apsis.server.web;

import io.github.apsis.engine.ShipReading;
import io.github.apsis.protocol.Frame;
import io.github.apsis.protocol.json.FrameEncoder;
import io.github.apsis.server.room.FrameSink;
import io.github.apsis.server.room.RoomFrame;
import io.github.apsis.server.room.RoomReadings;
import io.github.apsis.server.room.ShipEvents;
import io.github.apsis.server.room.WatchedShips;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicReference;
import lombok.extern.slf4j.Slf4j;
import org.jspecify.annotations.Nullable;
import org.springframework.scheduling.concurrent.CustomizableThreadFactory;
import tools.jackson.databind.json.JsonMapper;

/**
 * Encodes each frame once, on a thread of its own, and offers it to every subscriber. The newest wins here as well:
 * when encoding takes longer than a frame lasts, frames are skipped.
 */
@Slf4j
final class StompFrameSink implements FrameSink, AutoCloseable {
    private final ClientSessions sessions;
    private final JsonMapper json;
    private final FrameMapper mapper = new FrameMapper();
    private final FrameEncoder encoder = new FrameEncoder();
    private final AtomicReference<@Nullable RoomFrame> newest = new AtomicReference<>();
    private final ExecutorService thread;

    StompFrameSink(ClientSessions sessions, JsonMapper json) {
        this.sessions = sessions;
        this.json = json;
        CustomizableThreadFactory threads = new CustomizableThreadFactory("encode-");
        threads.setDaemon(true);
        this.thread = Executors.newSingleThreadExecutor(threads);
    }

    @Override
    public void publish(RoomFrame frame) {
        if (newest.getAndSet(frame) == null) {
            execute(this::sendNewest);
        }
    }

    @Override
    public void publish(RoomReadings readings) {
        execute(() -> send(readings));
    }

    @Override
    public void publish(WatchedShips ships) {
        execute(() -> send(ships));
    }

    @Override
    public void publish(ShipEvents events) {
        execute(() -> send(events));
    }

    private void execute(Runnable task) {
        try {
            thread.execute(task);
        } catch (RejectedExecutionException e) {
            log.debug("a frame came after the end");
        }
    }

    private void sendNewest() {
        RoomFrame frame = newest.getAndSet(null);
        if (frame != null && sessions.anySubscribed(Destinations.BODIES)) {
            sessions.publish(toBulletin(mapper.toFrame(frame), frame.speed()));
        }
    }

    private Bulletin toBulletin(Frame frame, double speed) {
        String headers = "tick:" + frame.tick() + "\ntime:" + frame.time() + "\nspeed:" + speed + "\nsent:"
                + System.currentTimeMillis() + "\n";
        return new Bulletin(Destinations.BODIES, headers, encoder.encode(frame));
    }

    private void send(RoomReadings readings) {
        if (sessions.anySubscribed(Destinations.DIAGNOSTICS)) {
            var diagnostics = ProtocolMapper.toDiagnostics(readings, sessions.count());
            sessions.publish(Bulletin.plain(Destinations.DIAGNOSTICS, json.writeValueAsString(diagnostics)));
        }
    }

    private void send(ShipEvents events) {
        if (sessions.anySubscribed(Destinations.EVENTS)) {
            String text = json.writeValueAsString(ProtocolMapper.toEvents(events));
            sessions.publish(Bulletin.plain(Destinations.EVENTS, text));
        }
    }

    /** To each client its own; a ship that several look at is encoded once. */
    private void send(WatchedShips ships) {
        Map<ShipReading, Bulletin> encoded = new IdentityHashMap<>();
        ships.byClient().forEach((client, reading) -> {
            ClientSession session = sessions.byId(client.value());
            if (session != null && session.isSubscribed(Destinations.SHIP)) {
                session.offer(encoded.computeIfAbsent(reading, r -> toBulletin(ships, r)));
            }
        });
    }

    private Bulletin toBulletin(WatchedShips ships, ShipReading reading) {
        var state = ProtocolMapper.toShipState(ships.tick(), ships.time(), reading);
        return Bulletin.plain(Destinations.SHIP, json.writeValueAsString(state));
    }

    @Override
    public void close() {
        thread.shutdown();
    }
}

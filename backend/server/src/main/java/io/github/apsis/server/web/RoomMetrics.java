package io.github.apsis.server.web;

import io.github.apsis.server.room.OpenRoom;
import io.github.apsis.server.room.Rooms;
import io.micrometer.core.instrument.FunctionCounter;
import io.micrometer.core.instrument.Gauge;
import io.micrometer.core.instrument.MeterRegistry;
import io.micrometer.core.instrument.binder.MeterBinder;
import lombok.RequiredArgsConstructor;
import org.springframework.stereotype.Component;

/** What an operator watches. */
@Component
@RequiredArgsConstructor
class RoomMetrics implements MeterBinder {
    private final Rooms rooms;
    private final ClientSessions sessions;

    @Override
    public void bindTo(MeterRegistry metrics) {
        rooms.all().forEach(room -> bind(room, metrics));
        Gauge.builder("apsis.clients", sessions, ClientSessions::count)
                .description("open sessions")
                .register(metrics);
        FunctionCounter.builder("apsis.frames.conflated", sessions, ClientSessions::conflated)
                .description("messages of streams that a newer one replaced before they were sent")
                .register(metrics);
        FunctionCounter.builder("apsis.rooms.failed", rooms, Rooms::failures)
                .description("rooms that threw and were replaced")
                .register(metrics);
    }

    private static void bind(OpenRoom room, MeterRegistry metrics) {
        String id = room.spec().id();
        Gauge.builder("apsis.tick.rate", room, r -> r.pace().ticksPerSecond())
                .description("ticks in the last second")
                .tag("room", id)
                .register(metrics);
        Gauge.builder("apsis.tick.seconds", room, r -> r.pace().p50Millis() / 1000)
                .description("length of a tick, last ten seconds")
                .tags("room", id, "quantile", "0.5")
                .register(metrics);
        Gauge.builder("apsis.tick.seconds", room, r -> r.pace().p99Millis() / 1000)
                .description("length of a tick, last ten seconds")
                .tags("room", id, "quantile", "0.99")
                .register(metrics);
        FunctionCounter.builder("apsis.ticks.late", room, r -> r.pace().lateTicks())
                .description("ticks that began more than half a period late")
                .tag("room", id)
                .register(metrics);
        FunctionCounter.builder("apsis.ticks.dropped", room, r -> r.pace().droppedTicks())
                .description("ticks that were given up")
                .tag("room", id)
                .register(metrics);
        Gauge.builder("apsis.clock.speed", room, r -> r.pace().speed())
                .description("of the room's clock, as a share of real time; below 1 the room is too heavy")
                .tag("room", id)
                .register(metrics);
        Gauge.builder("apsis.room.load", room, OpenRoom::load)
                .description("share of a processor that 150 ticks a second take")
                .tag("room", id)
                .register(metrics);
        Gauge.builder("apsis.bodies", room, OpenRoom::bodies)
                .description("bodies in the room")
                .tag("room", id)
                .register(metrics);
        bindShips(room, metrics);
    }

    private static void bindShips(OpenRoom room, MeterRegistry metrics) {
        String id = room.spec().id();
        FunctionCounter.builder("apsis.ship.collisions", room, r -> r.ships().collisions())
                .description("ships that ran into another body, two ships into each other once")
                .tag("room", id)
                .register(metrics);
        FunctionCounter.builder("apsis.ship.minutes", room, r -> r.ships().shipMinutes())
                .description("time that all ships together have flown, minutes of the room's clock")
                .tag("room", id)
                .register(metrics);
        Gauge.builder("apsis.ship.collisions.per.minute", room, r -> r.ships().collisionsPerShipMinute())
                .description("collisions per ship-minute since the room began")
                .tag("room", id)
                .register(metrics);
    }
}

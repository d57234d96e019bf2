package io.github.apsis.server.web;

import io.github.apsis.server.room.OpenRoom;
import io.github.apsis.server.room.Rooms;
import java.util.concurrent.TimeUnit;
import lombok.RequiredArgsConstructor;
import org.springframework.boot.health.contributor.Health;
import org.springframework.boot.health.contributor.HealthIndicator;
import org.springframework.stereotype.Component;

/** DOWN while a room stands still. */
@Component
@RequiredArgsConstructor
class RoomHealth implements HealthIndicator {
    /** Longer than it takes to replace a room that has failed. */
    private static final long STANDSTILL_NANOS = TimeUnit.SECONDS.toNanos(3);

    private final Rooms rooms;

    @Override
    public Health health() {
        for (OpenRoom room : rooms.all()) {
            if (room.nanosSinceLastTick() > STANDSTILL_NANOS) {
                return Health.down().withDetail("room", room.spec().id()).build();
            }
        }
        return Health.up().build();
    }
}

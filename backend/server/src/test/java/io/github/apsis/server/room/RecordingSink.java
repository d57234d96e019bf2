package io.github.apsis.server.room;

import java.util.ArrayList;
import java.util.List;

/** Keeps everything. */
final class RecordingSink implements FrameSink {
    final List<RoomFrame> frames = new ArrayList<>();
    final List<RoomReadings> readings = new ArrayList<>();
    final List<WatchedShips> ships = new ArrayList<>();
    final List<ShipEvents> events = new ArrayList<>();

    @Override
    public void publish(RoomFrame frame) {
        frames.add(frame);
    }

    @Override
    public void publish(RoomReadings reading) {
        readings.add(reading);
    }

    @Override
    public void publish(WatchedShips watched) {
        ships.add(watched);
    }

    @Override
    public void publish(ShipEvents news) {
        events.add(news);
    }

    RoomFrame last() {
        return frames.get(frames.size() - 1);
    }
}

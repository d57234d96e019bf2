package io.github.apsis.server.web;

import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.protocol.BodyState;
import io.github.apsis.protocol.Frame;
import io.github.apsis.protocol.Point;
import io.github.apsis.scenes.shape.Outline;
import io.github.apsis.server.room.Appearance;
import io.github.apsis.server.room.RoomFrame;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.WeakHashMap;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/** Turns a moment of a room into what clients see of it. Belongs to the thread that encodes. */
final class FrameMapper {
    // An outline never changes: the same list each time lets the encoder recognise it.
    private final Map<Outline, List<Point>> vertices = new WeakHashMap<>();

    Frame toFrame(RoomFrame frame) {
        WorldSnapshot world = frame.world();
        List<BodyState> bodies = new ArrayList<>(world.count());
        for (int i = 0; i < world.count(); i++) {
            bodies.add(toBody(frame, i));
        }
        return new Frame(world.tick(), world.time(), bodies);
    }

    private BodyState toBody(RoomFrame frame, int i) {
        WorldSnapshot world = frame.world();
        BodyId id = world.id(i);
        Appearance appearance = frame.appearances().get(id);
        return new BodyState(
                id.value(),
                ProtocolMapper.toKind(world.kind(i)),
                new Point(world.x(i), world.y(i)),
                new Point(world.vx(i), world.vy(i)),
                new Point(world.ax(i), world.ay(i)),
                world.mass(i),
                world.radius(i),
                frame.selected().contains(id),
                appearance == null ? null : (Double) appearance.angleAt(world.time()),
                appearance == null ? null : vertices(appearance.outline()),
                world.kind(i) == BodyKind.SHIP ? (Double) world.thrust(i) : null,
                target(world, i));
    }

    private static @Nullable Point target(WorldSnapshot world, int i) {
        return world.target(i).map(ProtocolMapper::toPoint).orElse(null);
    }

    private List<Point> vertices(Outline outline) {
        return vertices.computeIfAbsent(outline, FrameMapper::toPoints);
    }

    private static List<Point> toPoints(Outline outline) {
        return IntStream.range(0, outline.count())
                .mapToObj(vertex -> new Point(outline.x(vertex), outline.y(vertex)))
                .toList();
    }
}

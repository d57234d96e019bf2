package io.github.apsis.benchmarks.speed;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.protocol.BodyState;
import io.github.apsis.protocol.Frame;
import io.github.apsis.protocol.Kind;
import io.github.apsis.protocol.Point;
import io.github.apsis.scenes.Look;
import io.github.apsis.scenes.Scene;
import io.github.apsis.scenes.SceneBody;
import io.github.apsis.scenes.SceneCatalogue;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/** Frames of the public room, some ticks apart. */
public final class RoomFrames {
    private static final int TICKS_BETWEEN = 5; // thirty frames a second

    private final List<SceneBody> bodies;
    private final List<@Nullable List<Point>> outlines;
    private final World world;

    private RoomFrames(int count) {
        Scene scene = SceneCatalogue.byName("belt-and-swarm", count).orElseThrow();
        bodies = scene.bodies(1);
        outlines = bodies.stream().map(RoomFrames::outline).toList();
        world = scene.world(1);
    }

    /** So many frames of so many bodies. */
    public static List<Frame> of(int bodies, int frames) {
        RoomFrames room = new RoomFrames(bodies);
        List<Frame> all = new ArrayList<>();
        for (int k = 0; k < frames; k++) {
            for (int tick = 0; tick < TICKS_BETWEEN; tick++) {
                room.world.step();
            }
            all.add(room.now());
        }
        return all;
    }

    private Frame now() {
        WorldSnapshot now = world.snapshot();
        List<BodyState> states =
                IntStream.range(0, now.count()).mapToObj(i -> state(now, i)).toList();
        return new Frame(now.tick(), now.time(), states);
    }

    private BodyState state(WorldSnapshot now, int i) {
        Look look = bodies.get(i).look();
        boolean isShip = now.kind(i) == BodyKind.SHIP;
        return new BodyState(
                now.id(i).value(),
                Kind.valueOf(now.kind(i).name()),
                new Point(now.x(i), now.y(i)),
                new Point(now.vx(i), now.vy(i)),
                new Point(now.ax(i), now.ay(i)),
                now.mass(i),
                now.radius(i),
                false,
                look == null ? null : (Double) look.angleAfter(now.time()),
                outlines.get(i),
                isShip ? (Double) now.thrust(i) : null,
                null);
    }

    private static @Nullable List<Point> outline(SceneBody body) {
        Look look = body.look();
        return look == null
                ? null
                : IntStream.range(0, look.outline().count())
                        .mapToObj(k ->
                                new Point(look.outline().x(k), look.outline().y(k)))
                        .toList();
    }
}

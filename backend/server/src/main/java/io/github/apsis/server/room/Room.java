package io.github.apsis.server.room;

import io.github.apsis.engine.Command;
import io.github.apsis.engine.CommandResult;
import io.github.apsis.engine.Departure;
import io.github.apsis.engine.ShipReading;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.engine.force.GravitySolver;
import io.github.apsis.engine.math.Vec2;
import io.github.apsis.scenes.Measures;
import io.github.apsis.scenes.RandomBodies;
import io.github.apsis.scenes.SceneBody;
import io.github.apsis.server.room.Outcome.Done;
import io.github.apsis.server.room.Outcome.Reason;
import io.github.apsis.server.room.Outcome.Refused;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import lombok.extern.slf4j.Slf4j;
import org.jspecify.annotations.Nullable;

/**
 * One simulation that people watch and steer: a world, its command queue, its selections and its sink.
 *
 * <p>{@link #submit} and {@link #leave} may be called on any thread and return at once. Everything else belongs to the
 * tick thread, the only one that touches the world; answers are given there too, so an answer must not block.
 */
@Slf4j
public final class Room {
    static final int QUEUE_CAPACITY = 1024;

    /**
     * Every new body costs one evaluation of the forces and a search for its place: this many leave the tick its time.
     */
    static final int MOST_COMMANDS_PER_TICK = 8;

    private static final int READINGS_PER_SECOND = 4;
    private static final int SHIPS_PER_SECOND = 10;
    private static final int EVENTS_PER_SECOND = 5;

    private final RoomSpec spec;
    private final WorldSpec laws;
    private final World world;
    private final RandomBodies randomBodies;
    private final FrameSink sink;
    private final Supplier<Pace> pace;
    private final DoubleSupplier speed;
    private final Selections selections = new Selections();
    private final Appearances appearances = new Appearances();
    private final ConservationMeter conservation = new ConservationMeter();
    private final ShipChronicle chronicle;
    private final CommandQueue<Runnable> commands = new CommandQueue<>(QUEUE_CAPACITY);
    private @Nullable WorldSnapshot now;
    private long departed; // bodies that are done with
    private boolean hasWarned;
    private volatile int bodies;
    private volatile boolean closed;

    /**
     * Opens the room: builds the world of its scene. {@code pace}, which costs something, and {@code speed}, the share of real
     * time at which the clock runs, are asked on the tick thread.
     */
    Room(RoomSpec spec, FrameSink sink, Supplier<Pace> pace, DoubleSupplier speed) {
        this.spec = spec;
        this.sink = sink;
        this.pace = pace;
        this.speed = speed;
        this.laws = spec.scene().spec(spec.seed());
        this.world = new World(laws);
        this.randomBodies = new RandomBodies(spec.scene().palette(), laws, spec.seed());
        this.chronicle = new ShipChronicle(laws.shipsAreMortal());
        world.onBounce(chronicle.listener());
        spec.scene().bodies(spec.seed()).forEach(body -> welcome(world.add(body.def()), body));
    }

    /** Queues a request; the answer comes on the tick thread, or at once on this one when the room cannot take it. */
    void submit(ClientId client, Request request, Consumer<Outcome> answer) {
        boolean queued = !closed && commands.offer(() -> answer.accept(closed ? busy() : outcome(client, request)));
        if (!queued) {
            answer.accept(busy());
        } else if (closed) {
            refuseAll();
        }
    }

    /** The client is gone, and its selection with it. */
    void leave(ClientId client) {
        commands.force(() -> {
            if (!closed) {
                selections.leave(client);
            }
        });
    }

    /** One tick: what has arrived, then physics, then what is due to be seen. */
    void tick() {
        commands.drain(MOST_COMMANDS_PER_TICK, Runnable::run);
        chronicle.begin(world.tick() + 1);
        world.step();
        now = null;
        chronicle.end(world.tick(), world.time());
        forgetDeparted();
        bodies = world.count();
        double share = speed.getAsDouble();
        if (isDue(spec.framesPerSecond(), share)) {
            chronicle.look(snapshot());
            sink.publish(new RoomFrame(snapshot(), appearances.copy(), selections.ofAnyone(), share));
        }
        if (isDue(SHIPS_PER_SECOND, share) && !selections.last().isEmpty()) {
            publishShips();
        }
        if (isDue(EVENTS_PER_SECOND, share)) {
            chronicle.news(world.tick()).ifPresent(sink::publish);
        }
        if (isDue(READINGS_PER_SECOND, share)) {
            sink.publish(readings());
        }
    }

    private void publishShips() {
        Map<BodyId, Optional<ShipReading>> readings = new HashMap<>();
        Map<ClientId, ShipReading> byClient = new HashMap<>();
        selections.last().forEach((client, body) -> readings.computeIfAbsent(body, world::ship)
                .ifPresent(reading -> byClient.put(client, reading)));
        if (!byClient.isEmpty()) {
            sink.publish(new WatchedShips(world.tick(), world.time(), Map.copyOf(byClient)));
        }
    }

    /** What left of itself ends as what is removed: out of the frames, and nobody's selection. */
    private void forgetDeparted() {
        for (Departure departure : world.departuresSince(departed)) {
            if (departure.reason() != Departure.Reason.COLLIDED && !hasWarned) {
                hasWarned = true;
                log.warn(
                        "room {} lost body {} at tick {}: {}; more will not be logged",
                        spec.id(),
                        departure.body().value(),
                        departure.tick(),
                        departure.reason());
            }
            forget(departure.body());
        }
        departed = world.departed();
    }

    /** Refuses what waits and what still comes. */
    void close() {
        closed = true;
        refuseAll();
    }

    /** How many there were after the last tick. Any thread. */
    int bodies() {
        return bodies;
    }

    /** How its ships have fared. Any thread. */
    ShipTally ships() {
        return chronicle.tally();
    }

    /** A hash of the state of its world; for the tick thread, and for those who know that it stands still. */
    long worldHash() {
        return world.stateHash();
    }

    long worldTick() {
        return world.tick();
    }

    private synchronized void refuseAll() {
        commands.drain(Integer.MAX_VALUE, Runnable::run);
    }

    /** The bodies as they are now, copied when someone asks, and once only until they change. */
    private WorldSnapshot snapshot() {
        if (now == null) {
            now = world.snapshot();
        }
        return now;
    }

    private void bodiesChanged() {
        now = null;
        conservation.reset();
    }

    /** Whether the n-th part of a second has just begun: of real time, so that a slow clock does not make frames rare. */
    private boolean isDue(int timesPerSecond, double speed) {
        long tick = world.tick();
        if (speed < 1) {
            double perTick = Math.min(1, timesPerSecond / (speed * TickLoop.TICKS_PER_SECOND));
            return Math.floor(tick * perTick) != Math.floor((tick - 1) * perTick);
        }
        return tick * timesPerSecond / TickLoop.TICKS_PER_SECOND
                != (tick - 1) * timesPerSecond / TickLoop.TICKS_PER_SECOND;
    }

    private RoomReadings readings() {
        boolean asked = spec.scene().measures() == Measures.ENERGY_AND_MOMENTUM
                && world.count() <= ConservationMeter.MOST_BODIES;
        return new RoomReadings(
                world.tick(),
                world.time(),
                pace.get(),
                world.count(),
                nameOf(world.gravitySolver()),
                world.gravitySolver().sampledError(),
                asked ? Optional.of(conservation.measure(world)) : Optional.empty());
    }

    private static String nameOf(GravitySolver solver) {
        return switch (solver.method()) {
            case NONE -> "none";
            case DIRECT -> "direct";
            case TREE -> String.format(Locale.ROOT, "tree, opening %.2f", solver.theta());
            case NEAREST_IMAGE -> "nearest image";
        };
    }

    private Outcome outcome(ClientId client, Request request) {
        if (request instanceof Request.AddRandom add) {
            return add(add.what());
        } else if (request instanceof Request.Remove remove) {
            return remove(remove.body());
        } else if (request instanceof Request.MoveSelectedShips move) {
            return move(client, new Vec2(move.x(), move.y()));
        } else if (request instanceof Request.Select select) {
            return select(select.body(), () -> selections.select(client, select.body()));
        } else {
            BodyId body = ((Request.Deselect) request).body();
            return select(body, () -> selections.deselect(client, body));
        }
    }

    private Outcome add(Request.RandomBody what) {
        if (world.count() >= spec.maxBodies()) {
            return new Refused(Reason.WORLD_FULL);
        }
        Optional<SceneBody> body = randomBody(what, snapshot());
        return body.isPresent() ? add(body.get()) : new Refused(Reason.NO_ROOM);
    }

    private Optional<SceneBody> randomBody(Request.RandomBody what, WorldSnapshot now) {
        return switch (what) {
            case PLANET -> randomBodies.planet(now);
            case ASTEROID -> randomBodies.asteroid(now);
            case SHIP -> randomBodies.ship(now);
            case ANY -> randomBodies.any(now);
        };
    }

    private Outcome add(SceneBody body) {
        CommandResult result = world.apply(new Command.AddBody(body.def()));
        if (result instanceof CommandResult.Accepted accepted) {
            welcome(accepted.body(), body);
            bodiesChanged();
        }
        return outcome(result);
    }

    private void welcome(BodyId id, SceneBody body) {
        chronicle.add(id, body.def().kind());
        if (body.look() != null) {
            appearances.put(id, new Appearance(body.look(), world.time()));
        }
    }

    private Outcome remove(BodyId body) {
        CommandResult result = world.apply(new Command.RemoveBody(body));
        if (result instanceof CommandResult.Accepted) {
            forget(body);
        }
        return outcome(result);
    }

    private void forget(BodyId body) {
        selections.forget(body);
        appearances.forget(body);
        chronicle.forget(body);
        bodiesChanged();
    }

    private Outcome select(BodyId body, Runnable change) {
        if (snapshot().indexOf(body) < 0) {
            return new Refused(Reason.NO_SUCH_BODY);
        }
        change.run();
        return done(List.of(body));
    }

    private Outcome move(ClientId client, Vec2 point) {
        WorldSnapshot bodies = snapshot();
        List<Integer> ships = shipsOf(client, bodies);
        if (ships.isEmpty()) {
            return new Refused(Reason.NO_SHIP_SELECTED);
        }
        if (Edges.isOutside(laws.boundary(), point)) {
            return new Refused(Reason.OUTSIDE_WORLD);
        }
        // The nearest ship takes the point itself, the next ones the rings around it: few paths cross.
        ships.sort(Comparator.comparingDouble(i -> Math.hypot(bodies.x(i) - point.x(), bodies.y(i) - point.y())));
        double largest = ships.stream().mapToDouble(bodies::radius).max().orElseThrow();
        List<Vec2> slots = Formation.around(point, ships.size(), largest, laws.boundary());
        List<BodyId> sent = new ArrayList<>();
        for (int i = 0; i < ships.size(); i++) {
            BodyId ship = bodies.id(ships.get(i));
            Vec2 slot = slots.get(i);
            if (world.apply(new Command.SeekTarget(ship, slot.x(), slot.y())) instanceof CommandResult.Accepted) {
                sent.add(ship);
                chronicle.ordered(ship);
            }
        }
        return done(sent);
    }

    private List<Integer> shipsOf(ClientId client, WorldSnapshot bodies) {
        List<Integer> ships = new ArrayList<>();
        for (BodyId body : selections.of(client)) {
            int i = bodies.indexOf(body);
            if (i >= 0 && bodies.kind(i) == BodyKind.SHIP) {
                ships.add(i);
            }
        }
        return ships;
    }

    private Outcome outcome(CommandResult result) {
        if (result instanceof CommandResult.Accepted accepted) {
            return done(List.of(accepted.body()));
        }
        return new Refused(
                switch (((CommandResult.Rejected) result).reason()) {
                    case NO_SUCH_BODY -> Reason.NO_SUCH_BODY;
                    case NOT_A_SHIP -> Reason.NO_SHIP_SELECTED;
                    case OUTSIDE_WORLD -> Reason.OUTSIDE_WORLD;
                    case WORLD_FULL -> Reason.WORLD_FULL;
                });
    }

    private Outcome done(List<BodyId> bodies) {
        return new Done(bodies, world.tick() + 1);
    }

    private static Outcome busy() {
        return new Refused(Reason.ROOM_BUSY);
    }
}

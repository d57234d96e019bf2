package io.github.apsis.server.web;

import io.github.apsis.engine.ShipReading;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.diagnostics.Drift;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Vec2;
import io.github.apsis.protocol.ClientMessage;
import io.github.apsis.protocol.Diagnostics;
import io.github.apsis.protocol.Events;
import io.github.apsis.protocol.Kind;
import io.github.apsis.protocol.Point;
import io.github.apsis.protocol.Reply;
import io.github.apsis.protocol.RoomInfo;
import io.github.apsis.protocol.ShipState;
import io.github.apsis.scenes.Scene;
import io.github.apsis.scenes.Units;
import io.github.apsis.server.room.Conservation;
import io.github.apsis.server.room.Edges;
import io.github.apsis.server.room.Outcome;
import io.github.apsis.server.room.Pace;
import io.github.apsis.server.room.Request;
import io.github.apsis.server.room.RoomReadings;
import io.github.apsis.server.room.RoomSpec;
import io.github.apsis.server.room.ShipEvent;
import io.github.apsis.server.room.ShipEvents;
import java.util.Optional;
import java.util.OptionalDouble;
import org.jspecify.annotations.Nullable;

/** Turns the words of the treaty into those of the rooms, and back. */
final class ProtocolMapper {
    private static final int TICK_RATE = 150;

    private ProtocolMapper() {}

    static Request toRequest(ClientMessage.Add add) {
        Kind kind = add.kind();
        return new Request.AddRandom(kind == null ? Request.RandomBody.ANY : Request.RandomBody.valueOf(kind.name()));
    }

    static Request toRequest(ClientMessage.Select select) {
        BodyId body = new BodyId(select.id());
        return select.selected() ? new Request.Select(body) : new Request.Deselect(body);
    }

    static Request toRequest(ClientMessage.Delete delete) {
        return new Request.Remove(new BodyId(delete.id()));
    }

    static Request toRequest(ClientMessage.Move move) {
        return new Request.MoveSelectedShips(move.x(), move.y());
    }

    static Reply toReply(String command, Outcome.Done done) {
        return new Reply(command, done.bodies().stream().map(BodyId::value).toList(), done.tick());
    }

    static Diagnostics toDiagnostics(RoomReadings readings, int clients) {
        Optional<Conserved> now = readings.conservation().map(Conservation::now);
        Optional<Drift> drift = readings.conservation().map(Conservation::drift);
        Optional<Vec2> centre = now.flatMap(Conserved::centreOfMass);
        Pace pace = readings.pace();
        return new Diagnostics(
                readings.tick(),
                readings.time(),
                pace.ticksPerSecond(),
                new Diagnostics.TickMillis(pace.p50Millis(), pace.p99Millis()),
                pace.lateTicks(),
                pace.droppedTicks(),
                pace.speed(),
                readings.bodies(),
                clients,
                nullable(now.map(Conserved::kinetic)),
                number(now.map(Conserved::potential)),
                number(now.map(Conserved::energy)),
                number(drift.map(Drift::energy)),
                toPoint(now.map(ProtocolMapper::momentum)),
                nullable(drift.map(Drift::momentum)),
                nullable(now.map(Conserved::angularMomentum)),
                number(drift.map(Drift::angularMomentum)),
                nullable(centre.map(Vec2::x)),
                nullable(centre.map(Vec2::y)),
                number(now.map(Conserved::virialRatio)),
                readings.gravitySolver(),
                number(Optional.of(readings.forceError())));
    }

    static ShipState toShipState(long tick, double time, ShipReading reading) {
        return new ShipState(
                reading.ship().value(),
                tick,
                time,
                reading.target().map(ProtocolMapper::toPoint).orElse(null),
                toPoint(reading.course()),
                reading.evading(),
                toPoint(reading.acceleration()),
                reading.threat().map(ProtocolMapper::toThreat).orElse(null));
    }

    private static ShipState.@Nullable Threat toThreat(ShipReading.Threat threat) {
        ShipReading.Passing passing = threat.passing();
        if (!Double.isFinite(passing.gap())) {
            return null; // at the end of the numbers, and JSON has no infinity
        }
        return new ShipState.Threat(
                threat.body().value(),
                threat.timeToContact(),
                new ShipState.Passing(passing.time(), passing.gap(), toPoint(passing.ship()), toPoint(passing.body())));
    }

    static Events toEvents(ShipEvents events) {
        return new Events(
                events.tick(),
                events.unlisted(),
                events.events().stream().map(ProtocolMapper::toEvent).toList());
    }

    private static Events.Event toEvent(ShipEvent event) {
        Optional<ShipEvent.Encounter> met = event.encounter();
        return new Events.Event(
                event.number(),
                event.tick(),
                event.time(),
                Events.Type.valueOf(event.what().name()),
                event.ship().value(),
                met.map(other -> new Events.Other(other.other().value(), toKind(other.kind())))
                        .orElse(null),
                nullable(met.map(ShipEvent.Encounter::closingSpeed)));
    }

    static Kind toKind(BodyKind kind) {
        return switch (kind) {
            case PLANET -> Kind.PLANET;
            case ASTEROID -> Kind.ASTEROID;
            case SHIP -> Kind.SHIP;
        };
    }

    static RoomInfo toRoomInfo(RoomSpec room) {
        Scene scene = room.scene();
        Units units = scene.units();
        return new RoomInfo(
                room.id(),
                scene.name(),
                scene.title(),
                new RoomInfo.Units(units.length(), units.mass(), units.time()),
                toEdge(scene.spec(room.seed()).boundary()),
                toBox(scene.view()),
                TICK_RATE,
                room.framesPerSecond(),
                room.maxBodies(),
                scene.spec(room.seed()).shipsAreMortal() ? RoomInfo.Ships.MORTAL : RoomInfo.Ships.BOUNCE);
    }

    private static RoomInfo.Edge toEdge(Boundary boundary) {
        String kind = boundary instanceof Boundary.Walls ? "walls" : "periodic";
        return Edges.box(boundary)
                .map(box -> RoomInfo.Edge.of(kind, toBox(box)))
                .orElseGet(RoomInfo.Edge::open);
    }

    private static RoomInfo.Box toBox(Aabb box) {
        return new RoomInfo.Box(box.minX(), box.minY(), box.maxX(), box.maxY());
    }

    static Point toPoint(Vec2 point) {
        return new Point(point.x(), point.y());
    }

    private static Vec2 momentum(Conserved now) {
        return new Vec2(now.momentumX(), now.momentumY());
    }

    /** JSON has no infinity: what left the numbers was not measured. */
    private static @Nullable Double nullable(Optional<Double> value) {
        return value.filter(Double::isFinite).orElse(null);
    }

    private static @Nullable Double number(Optional<OptionalDouble> value) {
        return nullable(value.filter(OptionalDouble::isPresent).map(OptionalDouble::getAsDouble));
    }

    private static @Nullable Point toPoint(Optional<Vec2> vector) {
        return vector.filter(v -> Double.isFinite(v.x()) && Double.isFinite(v.y()))
                .map(ProtocolMapper::toPoint)
                .orElse(null);
    }
}

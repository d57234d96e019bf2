package io.github.apsis.server.room;

import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.engine.collision.ContactListener;
import io.github.apsis.server.room.Encounters.Collision;
import io.github.apsis.server.room.ShipEvent.Encounter;
import io.github.apsis.server.room.ShipEvent.What;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** What happens to the ships of a room, counted and told. Belongs to the tick thread; {@link #tally} may be asked on any. */
final class ShipChronicle {
    private final boolean mortal;
    private final Encounters encounters = new Encounters();
    private final Arrivals arrivals = new Arrivals();
    private final EventLog events = new EventLog();

    /** {@code mortal} says whether a collision is the end of a ship. */
    ShipChronicle(boolean mortal) {
        this.mortal = mortal;
    }

    /** Hears of every bounce. */
    ContactListener listener() {
        return encounters;
    }

    /** A body has come into the world. */
    void add(BodyId body, BodyKind kind) {
        encounters.add(body, kind);
    }

    /** A body has gone. */
    void forget(BodyId body) {
        encounters.remove(body);
        arrivals.forget(body);
    }

    /** A ship has been sent somewhere. */
    void ordered(BodyId ship) {
        arrivals.ordered(ship);
    }

    /** The next tick begins. */
    void begin(long tick) {
        encounters.begin(tick);
    }

    /** The tick is over, at this simulated time. */
    void end(long tick, double time) {
        List<Collision> collisions = encounters.end();
        if (mortal) {
            logDeaths(collisions, tick, time);
        } else {
            for (Collision collision : collisions) {
                log(What.COLLIDED, collision.ship(), collision, collision.other(), collision.otherKind(), tick, time);
            }
        }
    }

    /** A ship dies once, whatever it runs into in that tick; of two that meet, each has an event of its own. */
    private void logDeaths(List<Collision> collisions, long tick, double time) {
        if (collisions.isEmpty()) {
            return;
        }
        Set<BodyId> dead = new HashSet<>();
        for (Collision collision : collisions) {
            BodyId ship = collision.ship();
            BodyId other = collision.other();
            if (dead.add(ship)) {
                log(What.DESTROYED, ship, collision, other, collision.otherKind(), tick, time);
            }
            if (collision.otherKind() == BodyKind.SHIP && dead.add(other)) {
                log(What.DESTROYED, other, collision, ship, BodyKind.SHIP, tick, time);
            }
        }
    }

    private void log(What what, BodyId ship, Collision collision, BodyId other, BodyKind kind, long tick, double time) {
        events.add(tick, time, what, ship, Optional.of(new Encounter(other, kind, collision.closingSpeed())));
    }

    /** Looks who has arrived by now. */
    void look(WorldSnapshot now) {
        arrivals.check(now, ship -> events.add(now.tick(), now.time(), What.ARRIVED, ship, Optional.empty()));
    }

    /** The newest events, if any has happened since this was asked last. */
    Optional<ShipEvents> news(long tick) {
        return events.news(tick);
    }

    ShipTally tally() {
        return encounters.tally();
    }
}

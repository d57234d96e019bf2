package io.github.apsis.engine;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.collision.ContactListener;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * The ships that have run into another body in this tick, in a world where that is their end. They bounce like all others, so what they
 * hit gets its impulse, and leave when the tick is over. Walls do no harm.
 */
final class Wrecks implements ContactListener {
    private final Bodies bodies;
    private final List<Wreck> wrecks = new ArrayList<>(); // in the order of their times
    private @Nullable ContactListener next;

    private record Wreck(BodyId ship, BodyId other) {}

    Wrecks(Bodies bodies) {
        this.bodies = bodies;
    }

    /** Hands every bounce on to another listener. */
    void tell(ContactListener listener) {
        next = listener;
    }

    @Override
    public void bounced(double time, long first, long second, double closingSpeed, double impulse) {
        if (second > 0) { // no wall
            note(new BodyId(first), new BodyId(second));
            note(new BodyId(second), new BodyId(first));
        }
        if (next != null) {
            next.bounced(time, first, second, closingSpeed, impulse);
        }
    }

    private void note(BodyId ship, BodyId other) {
        if (bodies.isShip(bodies.slotOf(ship)) && wrecks.stream().noneMatch(wreck -> wreck.ship.equals(ship))) {
            wrecks.add(new Wreck(ship, other));
        }
    }

    /** Takes them out of the world, after this tick. */
    void clear(long tick, Departures departures) {
        for (Wreck wreck : wrecks) {
            bodies.remove(bodies.slotOf(wreck.ship));
            departures.add(new Departure(wreck.ship, tick, Departure.Reason.COLLIDED, Optional.of(wreck.other)));
        }
        wrecks.clear();
    }
}

package io.github.apsis.server.room;

import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.engine.collision.ContactListener;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Whom the ships of a room run into. A collision is a bounce of a ship with another body, once for the pair as long as it goes on: two
 * that bounce again within a second have not got away from each other. Walls do not count, and a meeting of two ships is one
 * collision, as in the figures of docs/steering.
 *
 * <p>Belongs to the tick thread; {@link #tally} may be asked on any.
 */
final class Encounters implements ContactListener {
    /** Bounces of a pair that are no farther apart are one collision. */
    static final int APART_TICKS = TickLoop.TICKS_PER_SECOND;

    private static final int FORGET_EVERY_TICKS = 10 * TickLoop.TICKS_PER_SECOND;

    private final Map<Long, BodyKind> kinds = new HashMap<>();
    private final Map<Pair, Long> lastBounce = new HashMap<>(); // tick
    private final List<Collision> fresh = new ArrayList<>();
    private long tick; // that is under way, or was last
    private int ships;
    private volatile ShipTally tally = new ShipTally(0, 0);

    private record Pair(long first, long second) {}

    /**
     * A ship has run into something.
     *
     * @param ship of two ships the one that the engine names first
     * @param closingSpeed along the line of centres just before, length / time
     */
    record Collision(BodyId ship, BodyId other, BodyKind otherKind, double closingSpeed) {}

    /** A body has come into the world. */
    void add(BodyId body, BodyKind kind) {
        kinds.put(body.value(), kind);
        ships += kind == BodyKind.SHIP ? 1 : 0;
    }

    /** A body has gone. */
    void remove(BodyId body) {
        ships -= kinds.remove(body.value()) == BodyKind.SHIP ? 1 : 0;
    }

    /** The next tick begins. */
    void begin(long newTick) {
        tick = newTick;
        fresh.clear();
        if (tick % FORGET_EVERY_TICKS == 0) {
            lastBounce.values().removeIf(last -> tick - last > APART_TICKS);
        }
    }

    @Override
    public void bounced(double time, long first, long second, double closingSpeed, double impulse) {
        BodyKind firstKind = kinds.get(first);
        BodyKind secondKind = kinds.get(second); // null for a wall
        if (firstKind == null || secondKind == null || firstKind != BodyKind.SHIP && secondKind != BodyKind.SHIP) {
            return;
        }
        Long last = lastBounce.put(new Pair(first, second), tick);
        if (last == null || tick - last > APART_TICKS) {
            fresh.add(
                    firstKind == BodyKind.SHIP
                            ? new Collision(new BodyId(first), new BodyId(second), secondKind, closingSpeed)
                            : new Collision(new BodyId(second), new BodyId(first), firstKind, closingSpeed));
        }
    }

    /** The tick is over: what began in it. */
    List<Collision> end() {
        tally = new ShipTally(tally.collisions() + fresh.size(), tally.shipTicks() + ships);
        return fresh;
    }

    ShipTally tally() {
        return tally;
    }
}

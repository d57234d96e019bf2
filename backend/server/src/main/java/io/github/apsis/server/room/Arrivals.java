package io.github.apsis.server.room;

import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.math.Vec2;
import java.util.HashSet;
import java.util.Iterator;
import java.util.Set;
import java.util.function.Consumer;

/**
 * Ships under way to where they are ordered. One has arrived, once for each order, when its target lies within its circle and it is no
 * faster than a radius per time unit. Belongs to the tick thread.
 */
final class Arrivals {
    private final Set<BodyId> underWay = new HashSet<>();

    void ordered(BodyId ship) {
        underWay.add(ship);
    }

    void forget(BodyId ship) {
        underWay.remove(ship);
    }

    /** Hands over those that have arrived by now. */
    void check(WorldSnapshot now, Consumer<BodyId> arrived) {
        for (Iterator<BodyId> ships = underWay.iterator(); ships.hasNext(); ) {
            BodyId ship = ships.next();
            if (isThere(now, now.indexOf(ship))) {
                ships.remove();
                arrived.accept(ship);
            }
        }
    }

    private static boolean isThere(WorldSnapshot now, int i) {
        Vec2 target = i < 0 ? null : now.target(i).orElse(null);
        return target != null
                && new Vec2(target.x() - now.x(i), target.y() - now.y(i)).length() <= now.radius(i)
                && new Vec2(now.vx(i), now.vy(i)).length() <= now.radius(i);
    }
}

package io.github.apsis.engine.collision;

import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.math.Period;
import java.util.function.IntPredicate;

/** How deep circles lie in each other and in walls, as a share of the smaller radius; asked of every pair, without a tree. */
final class Depth {
    private Depth() {}

    /** Of the deepest pair, nearest images in a periodic world; 0 when none overlap. */
    static double ofPairs(WorldSnapshot now, Boundary edge) {
        return ofPairs(now, edge, i -> false, i -> false);
    }

    /** The same but for pairs of fixed bodies, which nothing can part, and without some bodies. */
    static double ofPairs(WorldSnapshot now, Boundary edge, IntPredicate isFixed, IntPredicate isLeftOut) {
        var period = edge instanceof Boundary.Periodic p ? new Period(p.box()) : null;
        double deepest = 0;
        for (int i = 0; i < now.count(); i++) {
            for (int j = i + 1; j < now.count(); j++) {
                if (isFixed.test(i) && isFixed.test(j) || isLeftOut.test(i) || isLeftOut.test(j)) {
                    continue;
                }
                double dx = now.x(j) - now.x(i);
                double dy = now.y(j) - now.y(i);
                if (period != null) {
                    dx = period.nearestX(dx);
                    dy = period.nearestY(dy);
                }
                double overlap = now.radius(i) + now.radius(j) - Math.sqrt(dx * dx + dy * dy);
                deepest = Math.max(deepest, overlap / Math.min(now.radius(i), now.radius(j)));
            }
        }
        return deepest;
    }

    /** Of the rim that is deepest in a wall; 0 when all are inside, and where there are no walls. */
    static double inWalls(WorldSnapshot now, Boundary edge) {
        return inWalls(now, edge, i -> false);
    }

    /** The same without some bodies. */
    static double inWalls(WorldSnapshot now, Boundary edge, IntPredicate isLeftOut) {
        WallSet walls = WallSet.of(edge);
        double deepest = 0;
        for (int i = 0; i < now.count(); i++) {
            for (int wall = -1; walls != null && wall > walls.end() && !isLeftOut.test(i); wall--) {
                double gap = walls.gap(wall, now.x(i), now.y(i), now.radius(i));
                deepest = Math.max(deepest, -gap / now.radius(i));
            }
        }
        return deepest;
    }
}

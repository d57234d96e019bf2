package io.github.apsis.engine.diagnostics;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.spatial.Quadtree;

/** Counts the pairs of bodies in the same place, which do not pull each other: there is no direction to pull in. */
final class CoincidentPairs {
    /** Nearer than this the cube of a distance is no normal number, and gravity skips the pair; length. */
    private static final double SAME_PLACE = 2.8e-103;

    private CoincidentPairs() {}

    /** By a tree of points: n log n, unless they are many. */
    static long count(Bodies bodies) {
        var tree = new Quadtree();
        tree.begin(bodies.count());
        for (int i = 0; i < bodies.count(); i++) {
            tree.set(i, bodies.x(i), bodies.y(i), bodies.x(i), bodies.y(i));
        }
        tree.build();
        long pairs = 0;
        for (int i = 0; i < bodies.count(); i++) {
            double x = bodies.x(i);
            double y = bodies.y(i);
            int hits = tree.query(x - SAME_PLACE, y - SAME_PLACE, x + SAME_PLACE, y + SAME_PLACE);
            pairs += hits - 1; // itself is among them
        }
        return pairs / 2;
    }
}

package io.github.apsis.engine.collision;

import io.github.apsis.engine.math.Aabb;

/** The edge of a world. */
public sealed interface Boundary {
    /** Whether a circle may be put there: finite, and not beyond the edge. */
    boolean holds(double x, double y, double radius);

    /** No edge. */
    record Open() implements Boundary {
        @Override
        public boolean holds(double x, double y, double radius) {
            return Double.isFinite(x) && Double.isFinite(y);
        }
    }

    /**
     * Four walls that reflect the rims of bodies.
     *
     * @param box the inside
     * @param restitution share of the normal speed that is left after a bounce, 0 to 1
     */
    record Walls(Aabb box, double restitution) implements Boundary {
        public Walls {
            if (!(restitution >= 0 && restitution <= 1)) {
                throw new IllegalArgumentException("wall restitution must be 0 to 1, was " + restitution);
            }
        }

        @Override
        public boolean holds(double x, double y, double radius) {
            return box.contains(x - radius, y - radius) && box.contains(x + radius, y + radius);
        }
    }

    /**
     * What leaves on one side comes in on the other; distances, contacts and gravity take the nearest image.
     *
     * @param box one period; every body must be smaller than a quarter of it, or it would meet its own image
     */
    record Periodic(Aabb box) implements Boundary {
        @Override
        public boolean holds(double x, double y, double radius) {
            return box.contains(x, y) && radius < 0.25 * Math.min(box.width(), box.height());
        }
    }
}

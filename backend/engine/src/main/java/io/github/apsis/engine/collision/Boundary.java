package io.github.apsis.engine.collision;

import io.github.apsis.engine.math.Aabb;
import java.util.List;

/** The edge of a world. */
public sealed interface Boundary {
    /** Whether a circle lies there clear of the edge: finite, and not beyond. */
    boolean holds(double x, double y, double radius);

    /**
     * Whether a circle may be born there: its centre inside, and not too large to get clear of the edge. What lies in a wall is
     * pushed out by and by, as what lies in another body.
     */
    boolean takes(double x, double y, double radius);

    /** Whether there is something to bounce off. */
    static boolean hasWalls(Boundary boundary) {
        return boundary instanceof Walls || boundary instanceof HalfPlanes;
    }

    /** Share of the normal speed that its walls leave; 0 without walls. */
    static double wallRestitution(Boundary boundary) {
        if (boundary instanceof HalfPlanes halfPlanes) {
            return halfPlanes.restitution();
        }
        return boundary instanceof Walls walls ? walls.restitution() : 0;
    }

    /** No edge. */
    record Open() implements Boundary {
        @Override
        public boolean holds(double x, double y, double radius) {
            return Double.isFinite(x) && Double.isFinite(y);
        }

        @Override
        public boolean takes(double x, double y, double radius) {
            return holds(x, y, radius);
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
            requireRestitution(restitution);
        }

        @Override
        public boolean holds(double x, double y, double radius) {
            return box.contains(x - radius, y - radius) && box.contains(x + radius, y + radius);
        }

        @Override
        public boolean takes(double x, double y, double radius) {
            return box.contains(x, y) && 2 * radius <= Math.min(box.width(), box.height());
        }
    }

    /**
     * Reflecting walls in any direction: a floor, a slope, a wedge.
     *
     * @param insides what is left of the plane by each wall
     * @param restitution share of the normal speed that is left after a bounce, 0 to 1
     */
    record HalfPlanes(List<HalfPlane> insides, double restitution) implements Boundary {
        public HalfPlanes {
            insides = List.copyOf(insides);
            requireRestitution(restitution);
        }

        @Override
        public boolean holds(double x, double y, double radius) {
            return Double.isFinite(x)
                    && Double.isFinite(y)
                    && insides.stream().allMatch(p -> p.nx() * x + p.ny() * y - p.d() >= radius);
        }

        @Override
        public boolean takes(double x, double y, double radius) {
            return holds(x, y, 0);
        }
    }

    /**
     * The points with nx · x + ny · y ≥ d.
     *
     * @param nx of the unit normal, which points inwards
     * @param d distance of the wall from the origin along its normal, length
     */
    record HalfPlane(double nx, double ny, double d) {
        private static final double UNIT = 1e-9; // what may be lost in writing a normal down

        public HalfPlane {
            if (!(Math.abs(Math.hypot(nx, ny) - 1) <= UNIT)) {
                throw new IllegalArgumentException("normal must have length 1, was (" + nx + ", " + ny + ")");
            }
            if (!Double.isFinite(d)) {
                throw new IllegalArgumentException("d must be finite, was " + d);
            }
        }
    }

    private static void requireRestitution(double restitution) {
        if (!(restitution >= 0 && restitution <= 1)) {
            throw new IllegalArgumentException("wall restitution must be 0 to 1, was " + restitution);
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

        @Override
        public boolean takes(double x, double y, double radius) {
            return holds(x, y, radius);
        }
    }
}

package io.github.apsis.server.room;

import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Vec2;
import java.util.ArrayList;
import java.util.List;

/**
 * Where several ships go that are sent to one point: the points of a hexagonal lattice around it, from the inside out,
 * so that nobody is ordered into a neighbour.
 */
final class Formation {
    /** Distance of neighbours in radii of the largest ship: half a radius of air between two rims. */
    static final double SPACING_IN_RADII = 2.5;

    /** 3·64·65 + 1 slots: more than a room has ships. */
    private static final int MOST_RINGS = 64;

    private final Vec2 centre;
    private final double spacing;
    private final Boundary boundary;
    private final double margin;

    private Formation(Vec2 centre, double largestRadius, Boundary boundary) {
        this.boundary = boundary;
        this.margin = largestRadius;
        this.spacing = SPACING_IN_RADII * largestRadius;
        this.centre = inside(centre);
    }

    /**
     * Places for {@code count} ships. The first is the point itself, or the nearest that a ship can reach when a wall
     * is closer than its rim; places behind a wall are left out.
     */
    static List<Vec2> around(Vec2 point, int count, double largestRadius, Boundary boundary) {
        return new Formation(point, largestRadius, boundary).slots(count);
    }

    private List<Vec2> slots(int count) {
        List<Vec2> slots = new ArrayList<>(count);
        slots.add(centre);
        for (int ring = 1; slots.size() < count && ring <= MOST_RINGS; ring++) {
            addRing(ring, count, slots);
        }
        while (slots.size() < count) { // a world too small for a formation: let them sort it out
            slots.add(centre);
        }
        return slots;
    }

    /** A hexagon has six corners, and ring − 1 places between two of them. */
    private void addRing(int ring, int count, List<Vec2> slots) {
        for (int place = 0; place < 6 * ring && slots.size() < count; place++) {
            double side = Math.PI / 3 * (place / ring);
            double along = (double) (place % ring) / ring;
            double fromX = StrictMath.cos(side);
            double fromY = StrictMath.sin(side);
            double dx = fromX + along * (StrictMath.cos(side + Math.PI / 3) - fromX);
            double dy = fromY + along * (StrictMath.sin(side + Math.PI / 3) - fromY);
            addIfReachable(new Vec2(centre.x() + ring * spacing * dx, centre.y() + ring * spacing * dy), slots);
        }
    }

    private void addIfReachable(Vec2 slot, List<Vec2> slots) {
        if (boundary instanceof Boundary.Periodic periodic) {
            slots.add(wrapped(slot, periodic.box()));
        } else if (inside(slot).equals(slot)) {
            slots.add(slot);
        }
    }

    private Vec2 inside(Vec2 point) {
        if (!(boundary instanceof Boundary.Walls walls)) {
            return point;
        }
        Aabb box = walls.box();
        return new Vec2(
                clamp(point.x(), box.minX() + margin, box.maxX() - margin),
                clamp(point.y(), box.minY() + margin, box.maxY() - margin));
    }

    private static double clamp(double value, double min, double max) {
        return min > max ? (min + max) / 2 : Math.max(min, Math.min(max, value));
    }

    private static Vec2 wrapped(Vec2 point, Aabb box) {
        return new Vec2(wrap(point.x(), box.minX(), box.width()), wrap(point.y(), box.minY(), box.height()));
    }

    private static double wrap(double value, double min, double period) {
        return value - period * Math.floor((value - min) / period);
    }
}

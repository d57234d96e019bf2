package io.github.apsis.scenes;

import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Vec2;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/**
 * Which places of a world are taken. Circles are kept in the cells of a square grid that they touch, so a question looks
 * at the neighbours alone.
 */
final class FreeSpace {
    private static final int MOST_CELLS_A_SIDE = 512;
    private static final int MOST_PROPOSALS = 10_000;

    private final Aabb area;
    private final Boundary boundary;
    private final int columns;
    private final int rows;
    private final List<List<Circle>> cells = new ArrayList<>();

    private record Circle(double x, double y, double radius) {}

    /** Room for circles about as wide as {@code cell}, length; wider ones are allowed. */
    FreeSpace(Aabb area, Boundary boundary, double cell) {
        this.area = area;
        this.boundary = boundary;
        this.columns = cellsAlong(area.width(), cell);
        this.rows = cellsAlong(area.height(), cell);
        for (int i = 0; i < columns * rows; i++) {
            cells.add(new ArrayList<>(2));
        }
    }

    /** The places that the bodies of a world leave free. */
    static FreeSpace around(WorldSnapshot now, Aabb area, Boundary boundary) {
        double cell = Math.sqrt(area.width() * area.height() / Math.max(1, now.count()));
        FreeSpace space = new FreeSpace(area, boundary, cell);
        for (int i = 0; i < now.count(); i++) {
            space.take(now.x(i), now.y(i), now.radius(i));
        }
        return space;
    }

    private static int cellsAlong(double side, double cell) {
        return (int) Math.min(MOST_CELLS_A_SIDE, Math.max(1, Math.floor(side / cell)));
    }

    /** Puts a circle there, and its images across a periodic edge. */
    void take(double x, double y, double radius) {
        if (boundary instanceof Boundary.Periodic periodic) {
            takeWithImages(periodic.box(), x, y, radius);
        } else {
            put(new Circle(x, y, radius));
        }
    }

    private void takeWithImages(Aabb box, double x, double y, double radius) {
        for (int image = 0; image < 9; image++) {
            double imageX = x + (image % 3 - 1) * box.width();
            double imageY = y + (image / 3 - 1) * box.height();
            // An image further off than half a period is nearer on its other side.
            boolean near = Math.abs(imageX - (box.minX() + box.maxX()) / 2) <= box.width()
                    && Math.abs(imageY - (box.minY() + box.maxY()) / 2) <= box.height();
            if (near) {
                put(new Circle(imageX, imageY, radius));
            }
        }
    }

    private void put(Circle circle) {
        double r = circle.radius;
        for (int row = row(circle.y - r); row <= row(circle.y + r); row++) {
            for (int column = column(circle.x - r); column <= column(circle.x + r); column++) {
                cells.get(row * columns + column).add(circle);
            }
        }
    }

    /** The body at the first of the proposed places where it fits, which is then taken. */
    SceneBody settle(SceneBody body, double gap, Supplier<Vec2> places) {
        double radius = body.def().radius();
        for (int i = 0; i < MOST_PROPOSALS; i++) {
            Vec2 place = places.get();
            if (fits(place.x(), place.y(), radius, gap)) {
                take(place.x(), place.y(), radius);
                return body.at(place.x(), place.y());
            }
        }
        throw new IllegalStateException("no room for a body of radius " + radius + " in " + MOST_PROPOSALS + " throws");
    }

    /** Whether a circle fits there: inside the area and the walls, and no nearer to any other than the gap. */
    boolean fits(double x, double y, double radius, double gap) {
        if (!area.contains(x, y) || !clearOfWalls(x, y, radius)) {
            return false;
        }
        double reach = radius + gap;
        for (int row = row(y - reach); row <= row(y + reach); row++) {
            for (int column = column(x - reach); column <= column(x + reach); column++) {
                if (isTaken(cells.get(row * columns + column), x, y, reach)) {
                    return false;
                }
            }
        }
        return true;
    }

    private static boolean isTaken(List<Circle> circles, double x, double y, double reach) {
        for (Circle circle : circles) {
            double dx = circle.x - x;
            double dy = circle.y - y;
            double apart = circle.radius + reach;
            if (dx * dx + dy * dy < apart * apart) {
                return true;
            }
        }
        return false;
    }

    private boolean clearOfWalls(double x, double y, double radius) {
        if (boundary instanceof Boundary.Walls walls) {
            Aabb box = walls.box();
            return x - radius >= box.minX()
                    && x + radius <= box.maxX()
                    && y - radius >= box.minY()
                    && y + radius <= box.maxY();
        }
        return !(boundary instanceof Boundary.Periodic periodic)
                || periodic.box().contains(x, y);
    }

    private int column(double x) {
        return clamp((x - area.minX()) / area.width() * columns, columns);
    }

    private int row(double y) {
        return clamp((y - area.minY()) / area.height() * rows, rows);
    }

    private static int clamp(double cell, int count) {
        return (int) Math.max(0, Math.min(count - 1.0, Math.floor(cell)));
    }
}

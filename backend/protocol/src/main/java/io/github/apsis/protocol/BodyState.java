package io.github.apsis.protocol;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * What a client sees of one body. A field that is {@code null} does not travel.
 *
 * @param id positive, never reused in a room
 * @param acceleration by all forces, thrust included
 * @param radius of the bounding circle, which is what collides
 * @param selected whether anyone has selected it
 * @param angle asteroids: radians, counter-clockwise
 * @param vertices asteroids: the outline about the centre at angle 0, counter-clockwise
 * @param thrust ships: force of the engine as a share of its maximum, 0 to 1
 * @param target ships under an order: where it leads
 */
public record BodyState(
        long id,
        Kind kind,
        Point position,
        Point velocity,
        Point acceleration,
        double mass,
        double radius,
        boolean selected,
        @Nullable Double angle,
        @Nullable List<Point> vertices,
        @Nullable Double thrust,
        @Nullable Point target) {}

package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import org.jspecify.annotations.Nullable;

/**
 * Where two partners of a contact are to each other: a body and another, or a body and a wall. The normal points from the
 * first partner to the second; one instance is refilled for every contact.
 */
final class ContactGeometry {
    private final @Nullable WallSet walls;
    private final @Nullable Period period;

    double lineX; // along the normal, of any length: n without its root, whose rounding has a bias
    double lineY;
    double nx;
    double ny;
    double gap; // length, negative when they overlap
    double inverseMass; // of the pair, 1/m1 + 1/m2

    ContactGeometry(@Nullable WallSet walls, @Nullable Period period) {
        this.walls = walls;
        this.period = period;
    }

    /** Fills in the geometry of the partners at the given places. */
    void fill(Bodies bodies, int a, double xa, double ya, int b, double xb, double yb) {
        if (b < 0 && walls != null) {
            nx = -walls.normalX(b);
            ny = -walls.normalY(b);
            lineX = nx;
            lineY = ny;
            gap = walls.gap(b, xa, ya, bodies.radius(a));
            inverseMass = bodies.inverseMass(a);
            return;
        }
        double dx = xb - xa;
        double dy = yb - ya;
        if (period != null) {
            dx = period.nearestX(dx);
            dy = period.nearestY(dy);
        }
        double distance = Math.sqrt(dx * dx + dy * dy);
        turn(dx, dy, distance);
        gap = distance - bodies.radius(a) - bodies.radius(b);
        inverseMass = bodies.inverseMass(a) + bodies.inverseMass(b);
    }

    private void turn(double dx, double dy, double distance) {
        // Coincident centres have no line between them: the x axis is as good as any, and always the same.
        lineX = distance > 0 ? dx : 1;
        lineY = distance > 0 ? dy : 0;
        nx = distance > 0 ? dx / distance : 1;
        ny = distance > 0 ? dy / distance : 0;
    }

    /** Replaces the normal by the direction of another separation, or of its nearest image. */
    void turn(double separationX, double separationY) {
        double dx = period == null ? separationX : period.nearestX(separationX);
        double dy = period == null ? separationY : period.nearestY(separationY);
        turn(dx, dy, Math.sqrt(dx * dx + dy * dy));
    }

    /** Fills in the line of two bodies along a separation, or along that of its nearest image, and leaves the gap unknown. */
    void fillLine(Bodies bodies, int a, int b, double separationX, double separationY) {
        turn(separationX, separationY);
        gap = Double.NaN;
        inverseMass = bodies.inverseMass(a) + bodies.inverseMass(b);
    }

    /** The geometry where the bodies stand now, at the end of their paths. */
    void fillNow(Bodies bodies, int a, int b) {
        double xb = b < 0 ? 0 : bodies.x(b);
        double yb = b < 0 ? 0 : bodies.y(b);
        fill(bodies, a, bodies.x(a), bodies.y(a), b, xb, yb);
    }

    /** The gap as the bodies stand now, alone: without a normal it takes no division. */
    double gapNow(Bodies bodies, int a, int b) {
        if (b < 0 && walls != null) {
            return walls.gap(b, bodies.x(a), bodies.y(a), bodies.radius(a));
        }
        double dx = bodies.x(b) - bodies.x(a);
        double dy = bodies.y(b) - bodies.y(a);
        if (period != null) {
            dx = period.nearestX(dx);
            dy = period.nearestY(dy);
        }
        return Math.sqrt(dx * dx + dy * dy) - bodies.radius(a) - bodies.radius(b);
    }

    /** How fast the partners close at their present velocities; negative when they separate. */
    double closingSpeed(Bodies bodies, int a, int b) {
        double wx = (b < 0 ? 0 : bodies.vx(b)) - bodies.vx(a);
        double wy = (b < 0 ? 0 : bodies.vy(b)) - bodies.vy(a);
        return -(wx * nx + wy * ny);
    }

    /** The acceleration with which the partners separate along the normal. */
    double separatingAcceleration(Bodies bodies, int a, int b) {
        double bx = -Paths.accelerationX(bodies, a);
        double by = -Paths.accelerationY(bodies, a);
        if (b >= 0) {
            bx += Paths.accelerationX(bodies, b);
            by += Paths.accelerationY(bodies, b);
        }
        return bx * nx + by * ny;
    }
}

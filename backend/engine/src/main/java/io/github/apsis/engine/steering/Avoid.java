package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.spatial.Quadtree;
import org.jspecify.annotations.Nullable;

/**
 * Avoidance by closest approach: a neighbour that would come too close, both flying straight on, is answered with the
 * acceleration that moves the ship aside in time (after the unaligned collision avoidance of Reynolds 1999).
 *
 * <pre>
 *   t* = −(r·v)/v²     m = r + v t*     S = r1 + r2 + margin     |m| &lt; S:  a = −m̂ · 2 (S − |m|) / t*²
 * </pre>
 *
 * <p>A body whose gravity comes near what the engine can give counts as large as the circle where it does: beyond that
 * circle the ship can still leave.
 *
 * <p>r and v are relative; t* is cut to the horizon. Head-on, where m has no direction, everybody turns to the right. A share
 * of the push brakes. Pushes add up, capped at what the engine can give.
 */
final class Avoid {
    private static final double HORIZON = 2.5; // in stopping times
    private static final double MARGIN = 1.0; // in ship radii
    private static final double SAFETY = 1.6; // more than the bare need: others move aside too late, or not at all
    private static final double BRAKING = 0.35; // share of the push that slows the approach
    private static final double HEAD_ON = 0.05; // of S: below this miss distance the side is arbitrary

    private static final double ESCAPABLE = 0.7; // share of the largest acceleration that gravity may take

    private final Quadtree tree;
    private final double gravity; // G, length³ / (mass · time²)
    private final @Nullable Period period;

    Avoid(Quadtree tree, double gravity, @Nullable Period period) {
        this.tree = tree;
        this.gravity = gravity;
        this.period = period;
    }

    /** Adds up the pushes of all neighbours of the ship in slot {@code i}, at most its largest acceleration. */
    void push(Bodies bodies, int i, SteeringVector push) {
        push.set(0, 0);
        double most = bodies.maxForce(i) * bodies.inverseMass(i);
        double horizon = HORIZON * bodies.maxSpeed(i) / most;
        double reach = 2 * bodies.maxSpeed(i) * horizon; // what closes at twice the speed is met within the horizon
        int images = period == null ? 0 : 1; // on each side
        for (int column = -images; column <= images; column++) {
            for (int row = -images; row <= images; row++) {
                pushAwayFromImages(bodies, i, column, row, reach, horizon, most, push);
            }
        }
        push.limit(most);
    }

    /** Answers the neighbours whose nearest image lies so many periods away; (0, 0) in a world that does not repeat itself. */
    private void pushAwayFromImages(
            Bodies bodies, int i, int column, int row, double reach, double horizon, double most, SteeringVector push) {
        double x = bodies.x(i) + (period == null ? 0 : column * period.width());
        double y = bodies.y(i) + (period == null ? 0 : row * period.height());
        int hits = tree.query(x - reach, y - reach, x + reach, y + reach);
        for (int hit = 0; hit < hits; hit++) {
            int other = tree.found(hit);
            if (other != i && isNearestImage(bodies, i, other, column, row)) {
                pushAwayFrom(bodies, i, other, horizon, most, push);
            }
        }
    }

    private boolean isNearestImage(Bodies bodies, int i, int other, int column, int row) {
        return period == null
                || (Math.rint((bodies.x(other) - bodies.x(i)) / period.width()) == column
                        && Math.rint((bodies.y(other) - bodies.y(i)) / period.height()) == row);
    }

    private void pushAwayFrom(Bodies bodies, int i, int other, double horizon, double most, SteeringVector push) {
        double rx = bodies.x(other) - bodies.x(i);
        double ry = bodies.y(other) - bodies.y(i);
        if (period != null) {
            rx = period.nearestX(rx);
            ry = period.nearestY(ry);
        }
        double vx = bodies.vx(other) - bodies.vx(i);
        double vy = bodies.vy(other) - bodies.vy(i);
        double closing = -(rx * vx + ry * vy);
        double distance = Math.sqrt(rx * rx + ry * ry);
        double margin = MARGIN * bodies.radius(i);
        double pull = gravity * bodies.mass(other) / (ESCAPABLE * most);
        double size = bodies.radius(other);
        double touch = bodies.radius(i) + (pull > size * size ? Math.sqrt(pull) : size);
        double clear = touch + margin;
        if (distance < clear && distance > 0) {
            // Inside the margin already: straight away from it, harder the closer.
            double strength = most * Math.min(1, (clear - distance) / margin);
            push.add(-rx / distance * strength, -ry / distance * strength);
        }
        if (closing <= 0) {
            return;
        }
        double v2 = vx * vx + vy * vy;
        double miss2 = Math.max(0, distance * distance - closing * closing / v2);
        if (miss2 >= clear * clear) {
            return;
        }
        double untilClose = (closing - Math.sqrt(Math.max(0, (clear * clear - miss2) * v2))) / v2;
        if (untilClose > horizon) {
            return;
        }
        double t = closing / v2;
        double mx = rx + vx * t;
        double my = ry + vy * t;
        double miss = Math.sqrt(miss2);
        double speed = Math.sqrt(v2);
        // v is the other's motion as seen from here, −v the way ahead: its right-hand side is (−vy, vx).
        boolean headOn = miss < HEAD_ON * clear;
        double awayX = headOn ? -vy / speed : -mx / miss;
        double awayY = headOn ? vx / speed : -my / miss;
        double strength = Math.min(most, SAFETY * 2 * (clear - miss) / (t * t));
        push.add(strength * (awayX + BRAKING * vx / speed), strength * (awayY + BRAKING * vy / speed));
    }
}

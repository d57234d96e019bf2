package io.github.apsis.benchmarks.contacts;

import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.collision.Boundary.HalfPlane;
import java.util.Arrays;

/**
 * How far the bodies part after each bounce: above the first wall under a uniform field that pulls straight down there, or
 * from each other under their gravity.
 *
 * <pre>
 *   h = n·r − d − R + v_n² / (2 g)          1 / h = 1 / r − v² / (2 G (m₁ + m₂))
 * </pre>
 *
 * <p>read where a tick is nearest to the highest point: true whether or not a tick falls on it.
 */
final class Apexes {
    private static final double STRAIGHT = 1e-12;

    private final ContactCase known;
    private final double pull; // of the field onto the wall, length / time²
    private final double[] heights;
    private final double[] slowest; // speed at which the height was read

    Apexes(ContactCase known) {
        this.known = known;
        this.pull = fieldOntoWall(known);
        boolean radial = known.g() > 0 && known.bodies().size() == 2;
        this.heights = new double[pull > 0 || radial ? known.apexHeights().length : 0];
        this.slowest = new double[heights.length];
        Arrays.fill(heights, Double.NaN);
        Arrays.fill(slowest, Double.POSITIVE_INFINITY);
    }

    /** 0 where there is no such wall, or where the field does not pull straight onto it. */
    private static double fieldOntoWall(ContactCase known) {
        if (known.g() != 0 || known.bodies().size() != 1 || known.walls().isEmpty()) {
            return 0;
        }
        HalfPlane wall = known.walls().get(0);
        double field = Math.hypot(known.fieldX(), known.fieldY());
        double along = -(wall.nx() * known.fieldX() + wall.ny() * known.fieldY());
        return Math.abs(along - field) <= STRAIGHT * field ? along : 0;
    }

    /** Looks at a state after so many bounces. */
    void look(WorldSnapshot now, int bounces) {
        if (bounces >= 1
                && bounces <= heights.length
                && now.count() == known.bodies().size()) {
            double speed = pull > 0 ? rising(now) : parting(now);
            if (Math.abs(speed) < slowest[bounces - 1]) {
                slowest[bounces - 1] = Math.abs(speed);
                heights[bounces - 1] = pull > 0 ? aboveWall(now, speed) : apart(now, speed);
            }
        }
    }

    private double rising(WorldSnapshot now) {
        HalfPlane wall = known.walls().get(0);
        return wall.nx() * now.vx(0) + wall.ny() * now.vy(0);
    }

    private double aboveWall(WorldSnapshot now, double speed) {
        HalfPlane wall = known.walls().get(0);
        double height = wall.nx() * now.x(0) + wall.ny() * now.y(0) - wall.d() - now.radius(0);
        return height + speed * speed / (2 * pull);
    }

    private static double parting(WorldSnapshot now) {
        return Math.hypot(now.vx(1) - now.vx(0), now.vy(1) - now.vy(0));
    }

    private double apart(WorldSnapshot now, double speed) {
        double mu = known.g() * (now.mass(0) + now.mass(1));
        return 1 / (1 / now.distance(0, 1) - speed * speed / (2 * mu));
    }

    /** NaN where no tick fell between two bounces. */
    double[] heights() {
        return heights;
    }
}

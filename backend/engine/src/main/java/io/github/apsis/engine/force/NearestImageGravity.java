package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Period;

/**
 * Newtonian gravity in a world that repeats itself: every body pulls with its nearest image alone (the minimum image
 * convention of Metropolis et al. 1953, J. Chem. Phys. 21, 1087), not with the infinite lattice.
 *
 * <p>The pull jumps where the nearest image changes, half a period away, so this law has no potential. Momentum is conserved
 * to rounding.
 */
public final class NearestImageGravity implements ForceLaw {
    private final double g; // length³ / (mass · time²)
    private final double softeningSquared; // length²
    private final Period period;

    public NearestImageGravity(double g, double softening, Aabb box) {
        this.g = g;
        this.softeningSquared = softening * softening;
        this.period = new Period(box);
    }

    @Override
    public void apply(Bodies bodies) {
        int count = bodies.count();
        for (int i = 0; i < count; i++) {
            for (int j = i + 1; j < count; j++) {
                double dx = period.nearestX(bodies.x(j) - bodies.x(i));
                double dy = period.nearestY(bodies.y(j) - bodies.y(i));
                double d2 = dx * dx + dy * dy + softeningSquared;
                double d3 = d2 * Math.sqrt(d2);
                if (!(d3 >= Double.MIN_NORMAL && d3 <= Double.MAX_VALUE)) {
                    continue; // coincident centres, whose pull has no direction, or so far that it is 0
                }
                double pull = g / d3;
                bodies.accelerate(i, pull * bodies.mass(j) * dx, pull * bodies.mass(j) * dy);
                bodies.accelerate(j, -pull * bodies.mass(i) * dx, -pull * bodies.mass(i) * dy);
            }
        }
    }
}

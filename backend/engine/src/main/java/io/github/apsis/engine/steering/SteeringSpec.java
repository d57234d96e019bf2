package io.github.apsis.engine.steering;

/**
 * How ships steer.
 *
 * @param arrival how they come to rest at a target
 * @param slowingRadius distance from a target at which a linear arrival begins to slow down, length
 * @param avoidance how they keep clear of others
 */
public record SteeringSpec(Arrival arrival, double slowingRadius, Avoidance avoidance) {
    /** Planned avoidance and the linear arrival. */
    public static final SteeringSpec DEFAULT = new SteeringSpec(Arrival.LINEAR, 100, Avoidance.PLANNED);

    public SteeringSpec {
        if (!(slowingRadius > 0) || Double.isInfinite(slowingRadius)) {
            throw new IllegalArgumentException("slowingRadius must be positive and finite, was " + slowingRadius);
        }
    }

    /** The same with this slowing radius. */
    public SteeringSpec slowingWithin(double radius) {
        return new SteeringSpec(arrival, radius, avoidance);
    }

    /** The same with this arrival. */
    public SteeringSpec arriving(Arrival how) {
        return new SteeringSpec(how, slowingRadius, avoidance);
    }

    /** The same with this avoidance. */
    public SteeringSpec avoiding(Avoidance how) {
        return new SteeringSpec(arrival, slowingRadius, how);
    }

    /** How a ship comes to rest at its target. */
    public enum Arrival {
        /** Speed in proportion to the distance within the slowing radius: gentle, with a long tail. */
        LINEAR,
        /** As fast as the engine can still stop: within hundredths of the shortest time. */
        BRAKING
    }

    /** How a ship keeps clear of others. */
    public enum Avoidance {
        /** Courses are tried out against what the others will do, and the best is flown: {@link Planner}. */
        PLANNED,
        /** The sum of unit vectors over distances, added to what the ship wants; for comparison. */
        SOURCE,
        /** The same, and none at all for a ship that has a target; for comparison. */
        SOURCE_SEEK_FIRST,
        /** Not at all. */
        NONE
    }
}

package io.github.apsis.engine;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.math.Vec2;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * What a ship is doing, for those who watch it.
 *
 * @param target where it wants to be; empty while it wanders
 * @param course the velocity that it is on its way to, length / time
 * @param evading whether that is a detour for the sake of others
 * @param acceleration of its engine, length / time²
 * @param threat what it would come too close to first if it did as it likes; empty when there is nothing
 */
public record ShipReading(
        BodyId ship, Optional<Vec2> target, Vec2 course, boolean evading, Vec2 acceleration, Optional<Threat> threat) {
    /**
     * A body that is in the way.
     *
     * @param timeToContact or to the closest approach, as it was when the ship last thought
     * @param passing how the two will pass each other on the course that was chosen
     */
    public record Threat(BodyId body, double timeToContact, Passing passing) {}

    /**
     * The closest approach of a ship on its course and a body that goes straight on:
     *
     * <pre>
     *   t = max(0, −d·w / w²)        gap = |d + w t| − r₁ − r₂
     * </pre>
     *
     * <p>with d the line between the centres and w the velocity of the body against the course.
     *
     * @param time from now
     * @param gap between the rims; negative where they would touch, length
     * @param ship where its centre will be
     * @param body where the centre of the other will be; in a world that repeats itself the image that is nearest to the ship
     */
    public record Passing(double time, double gap, Vec2 ship, Vec2 body) {}

    static ShipReading of(Bodies bodies, int i, @Nullable Period period) {
        double perMass = bodies.inverseMass(i);
        int threat = bodies.threat(i) == 0 ? -1 : bodies.slotOf(new BodyId(bodies.threat(i)));
        return new ShipReading(
                bodies.id(i),
                bodies.hasTarget(i) ? Optional.of(new Vec2(bodies.targetX(i), bodies.targetY(i))) : Optional.empty(),
                new Vec2(bodies.courseX(i), bodies.courseY(i)),
                bodies.isEvading(i),
                new Vec2(bodies.thrustX(i) * perMass, bodies.thrustY(i) * perMass),
                threat < 0 // also when the body has gone since the ship last thought
                        ? Optional.empty()
                        : Optional.of(new Threat(
                                bodies.id(threat), bodies.contactIn(i), passing(bodies, i, threat, period))));
    }

    private static Passing passing(Bodies bodies, int i, int other, @Nullable Period period) {
        double dx = bodies.x(other) - bodies.x(i);
        double dy = bodies.y(other) - bodies.y(i);
        if (period != null) {
            dx = period.nearestX(dx);
            dy = period.nearestY(dy);
        }
        double wx = bodies.vx(other) - bodies.courseX(i);
        double wy = bodies.vy(other) - bodies.courseY(i);
        double w2 = wx * wx + wy * wy;
        double time = w2 > 0 ? Math.max(0, -(dx * wx + dy * wy) / w2) : 0;
        double distance = new Vec2(dx + wx * time, dy + wy * time).length();
        double x = bodies.x(i) + bodies.courseX(i) * time;
        double y = bodies.y(i) + bodies.courseY(i) * time;
        return new Passing(
                time,
                distance - bodies.radius(i) - bodies.radius(other),
                new Vec2(x, y),
                new Vec2(x + dx + wx * time, y + dy + wy * time));
    }
}

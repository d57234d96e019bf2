package io.github.apsis.engine;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.math.Vec2;
import java.util.Optional;

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
     */
    public record Threat(BodyId body, double timeToContact) {}

    static ShipReading of(Bodies bodies, int i) {
        double perMass = bodies.inverseMass(i);
        return new ShipReading(
                bodies.id(i),
                bodies.hasTarget(i) ? Optional.of(new Vec2(bodies.targetX(i), bodies.targetY(i))) : Optional.empty(),
                new Vec2(bodies.courseX(i), bodies.courseY(i)),
                bodies.isEvading(i),
                new Vec2(bodies.thrustX(i) * perMass, bodies.thrustY(i) * perMass),
                bodies.threat(i) == 0
                        ? Optional.empty()
                        : Optional.of(new Threat(new BodyId(bodies.threat(i)), bodies.contactIn(i))));
    }
}

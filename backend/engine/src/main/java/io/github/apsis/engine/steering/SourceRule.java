package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;

/**
 * The rule that Apsis began with, for comparison: every neighbour pushes away by its unit vector over the distance.
 *
 * <pre>
 *   Δv = limit(limit(Σ r̂ / r) + limit(v_preferred − v)),   each to what the engine gives in a tick
 * </pre>
 *
 * <p>It neither knows velocities nor adds up to much: one neighbour at a distance of 50 takes 1.5 % of an engine that can do 200
 * units/s² at 150 ticks a second. Visits all bodies for each ship.
 */
final class SourceRule {
    private static final double RANGE = 100; // from rim to rim, length

    private SourceRule() {}

    /** Fills in an acceleration. */
    static void thrust(
            Bodies bodies, int i, SteeringVector preferred, boolean seekFirst, double dt, SteeringVector command) {
        double most = bodies.maxForce(i) * bodies.inverseMass(i) * dt; // speed
        command.set(0, 0);
        for (int j = 0; j < bodies.count() && !seekFirst; j++) {
            double dx = bodies.x(i) - bodies.x(j);
            double dy = bodies.y(i) - bodies.y(j);
            double d = Math.sqrt(dx * dx + dy * dy);
            if (j != i && d > 0 && d - bodies.radius(i) - bodies.radius(j) < RANGE) {
                command.add(dx / d / d, dy / d / d);
            }
        }
        command.limit(most);
        double wishX = preferred.x - bodies.vx(i);
        double wishY = preferred.y - bodies.vy(i);
        double wish = Math.sqrt(wishX * wishX + wishY * wishY);
        double cut = wish > most ? most / wish : 1;
        command.add(wishX * cut, wishY * cut);
        command.limit(most);
        command.set(command.x / dt, command.y / dt);
    }
}

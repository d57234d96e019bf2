package io.github.apsis.engine.body;

/**
 * What a ship's engine can do.
 *
 * @param maxSpeed the speed that thrust alone never exceeds, length / time; gravity may
 * @param maxForce the largest thrust, mass · length / time²
 */
public record ShipLimits(double maxSpeed, double maxForce) {
    public ShipLimits {
        BodyDef.requirePositive("maxSpeed", maxSpeed);
        BodyDef.requirePositive("maxForce", maxForce);
    }
}

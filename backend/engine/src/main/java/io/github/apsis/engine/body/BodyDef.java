package io.github.apsis.engine.body;

import org.jspecify.annotations.Nullable;

/**
 * What a caller asks for when it adds a body. Lengths, masses and speeds in the units of the scene.
 *
 * @param kind what it is
 * @param x position of the centre, length
 * @param y position of the centre, length
 * @param vx velocity, length / time; 0 for a fixed body
 * @param vy velocity, length / time; 0 for a fixed body
 * @param mass finite and 0 or more, for a ship more: a body without mass feels the others and they do not feel it
 * @param radius of the bounding circle, which is what collides; 0 makes a point
 * @param mobility whether it moves
 * @param limits of a ship's engine; {@code null} for everything else
 */
public record BodyDef(
        BodyKind kind,
        double x,
        double y,
        double vx,
        double vy,
        double mass,
        double radius,
        Mobility mobility,
        @Nullable ShipLimits limits) {
    public BodyDef {
        requireFinite("x", x);
        requireFinite("y", y);
        requireFinite("vx", vx);
        requireFinite("vy", vy);
        requireNotNegative("mass", mass);
        requireNotNegative("radius", radius);
        if (mobility == Mobility.FIXED && (vx != 0 || vy != 0)) {
            throw new IllegalArgumentException("a fixed body has no velocity, was (" + vx + ", " + vy + ")");
        }
        if ((kind == BodyKind.SHIP) != (limits != null)) {
            throw new IllegalArgumentException("a ship needs limits and only a ship has them: " + kind + ", " + limits);
        }
        if (kind == BodyKind.SHIP) {
            requirePositive("mass of a ship", mass);
        }
    }

    /** A planet at rest. */
    public static BodyDef planet(double x, double y, double mass, double radius) {
        return new BodyDef(BodyKind.PLANET, x, y, 0, 0, mass, radius, Mobility.FREE, null);
    }

    /** An asteroid at rest. */
    public static BodyDef asteroid(double x, double y, double mass, double radius) {
        return new BodyDef(BodyKind.ASTEROID, x, y, 0, 0, mass, radius, Mobility.FREE, null);
    }

    /** A ship at rest. */
    public static BodyDef ship(double x, double y, double mass, double radius, ShipLimits limits) {
        return new BodyDef(BodyKind.SHIP, x, y, 0, 0, mass, radius, Mobility.FREE, limits);
    }

    /** The same body with this velocity. */
    public BodyDef moving(double vx, double vy) {
        return new BodyDef(kind, x, y, vx, vy, mass, radius, mobility, limits);
    }

    /** The same body elsewhere. */
    public BodyDef at(double x, double y) {
        return new BodyDef(kind, x, y, vx, vy, mass, radius, mobility, limits);
    }

    /** The same body, at rest for good. */
    public BodyDef fixed() {
        return new BodyDef(kind, x, y, 0, 0, mass, radius, Mobility.FIXED, limits);
    }

    static void requireFinite(String name, double value) {
        if (!Double.isFinite(value)) {
            throw new IllegalArgumentException(name + " must be finite, was " + value);
        }
    }

    private static void requireNotNegative(String name, double value) {
        if (!(value >= 0) || Double.isInfinite(value)) { // the negation also catches NaN
            throw new IllegalArgumentException(name + " must be 0 or more and finite, was " + value);
        }
    }

    static void requirePositive(String name, double value) {
        if (!(value > 0) || Double.isInfinite(value)) { // the negation also catches NaN
            throw new IllegalArgumentException(name + " must be positive and finite, was " + value);
        }
    }
}

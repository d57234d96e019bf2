package io.github.apsis.engine.math;

/** A box with sides along the axes. Lengths. */
public record Aabb(double minX, double minY, double maxX, double maxY) {
    public Aabb {
        if (!(minX < maxX) || !(minY < maxY) || !Double.isFinite(maxX - minX) || !Double.isFinite(maxY - minY)) {
            throw new IllegalArgumentException("a box needs min < max and finite sides, was x " + minX + " to " + maxX
                    + ", y " + minY + " to " + maxY);
        }
    }

    /** The box from (−halfWidth, −halfHeight) to (halfWidth, halfHeight). */
    public static Aabb centred(double halfWidth, double halfHeight) {
        return new Aabb(-halfWidth, -halfHeight, halfWidth, halfHeight);
    }

    public double width() {
        return maxX - minX;
    }

    public double height() {
        return maxY - minY;
    }

    /** Whether the point lies inside or on the rim; false for NaN. */
    public boolean contains(double x, double y) {
        return x >= minX && x <= maxX && y >= minY && y <= maxY;
    }
}

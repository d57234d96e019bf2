package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.CompensatedSum;
import java.util.OptionalDouble;

/** The same acceleration everywhere, as near the ground: a = (gx, gy), potential −Σ m (gx x + gy y). */
public final class UniformField implements ForceLaw {
    private final double gx; // length / time²
    private final double gy;

    public UniformField(double gx, double gy) {
        if (!Double.isFinite(gx) || !Double.isFinite(gy)) {
            throw new IllegalArgumentException("a field must be finite, was (" + gx + ", " + gy + ")");
        }
        this.gx = gx;
        this.gy = gy;
    }

    /** Length / time². */
    public double gx() {
        return gx;
    }

    /** Length / time². */
    public double gy() {
        return gy;
    }

    @Override
    public void apply(Bodies bodies) {
        for (int i = 0; i < bodies.count(); i++) {
            bodies.accelerate(i, gx, gy);
        }
    }

    @Override
    public boolean isOuter() {
        return true;
    }

    @Override
    public OptionalDouble potential(Bodies bodies) {
        var sum = new CompensatedSum();
        for (int i = 0; i < bodies.count(); i++) {
            sum.add(-bodies.mass(i) * (gx * bodies.x(i) + gy * bodies.y(i)));
        }
        return OptionalDouble.of(sum.value());
    }
}

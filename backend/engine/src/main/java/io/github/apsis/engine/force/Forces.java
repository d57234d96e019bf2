package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.CompensatedSum;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.Stream;

/** The sum of all force laws of a world. */
public final class Forces {
    private final ForceLaw[] laws; // outer ones first
    private final int outer;

    public Forces(List<ForceLaw> laws) {
        this.laws = Stream.concat(
                        laws.stream().filter(ForceLaw::isOuter), laws.stream().filter(law -> !law.isOuter()))
                .toArray(ForceLaw[]::new);
        this.outer = (int) laws.stream().filter(ForceLaw::isOuter).count();
    }

    /** Makes every acceleration belong to the present positions. */
    public void evaluate(Bodies bodies) {
        if (laws.length == 0) {
            bodies.setUnforced();
            return;
        }
        bodies.clearAccelerations();
        for (int k = 0; k < laws.length; k++) {
            laws[k].apply(bodies);
            if (k + 1 == outer) {
                bodies.noteOutsideForces();
            }
        }
        bodies.completeAccelerations();
    }

    /** Evaluates only when something has moved since the last time. */
    public void ensureCurrent(Bodies bodies) {
        if (!bodies.accelerationsCurrent()) {
            evaluate(bodies);
        }
    }

    /** Potential energy of all laws together; empty when one of them has none. */
    public OptionalDouble potential(Bodies bodies) {
        var sum = new CompensatedSum();
        for (ForceLaw law : laws) {
            OptionalDouble part = law.potential(bodies);
            if (part.isEmpty()) {
                return OptionalDouble.empty();
            }
            sum.add(part.getAsDouble());
        }
        return OptionalDouble.of(sum.value());
    }
}

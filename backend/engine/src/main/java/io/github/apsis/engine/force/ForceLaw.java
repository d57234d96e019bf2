package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;
import java.util.OptionalDouble;

/**
 * A law that accelerates bodies. Users of the engine write their own; a law may keep scratch memory, so it belongs to one
 * world.
 */
public interface ForceLaw {
    /** Adds this law's acceleration to every body, by {@link Bodies#accelerate} and nothing else. */
    void apply(Bodies bodies);

    /**
     * Whether the law pushes from outside, as a field does, and not in equal and opposite pairs: what it gives the bodies is then
     * booked, and no error of their momentum.
     */
    default boolean isOuter() {
        return false;
    }

    /** The potential energy of the present positions; empty when the law has none, or none is known. */
    default OptionalDouble potential(Bodies bodies) {
        return OptionalDouble.empty();
    }
}

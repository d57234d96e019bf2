package io.github.apsis.engine.force;

import java.util.OptionalDouble;

/**
 * How a world works out its gravity at present.
 *
 * @param method by which sum
 * @param theta opening angle of the tree; 0 for the others
 * @param sampledError relative error that nine of ten sampled bodies met when last looked at; empty when it never is
 */
public record GravitySolver(Method method, double theta, OptionalDouble sampledError) {
    /** The sums there are. */
    public enum Method {
        NONE,
        DIRECT,
        TREE,
        NEAREST_IMAGE
    }

    /** A sum that is never compared with another. */
    public static GravitySolver of(Method method, double theta) {
        return new GravitySolver(method, theta, OptionalDouble.empty());
    }
}

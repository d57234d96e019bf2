package io.github.apsis.protocol;

/** A point or a vector in scene units, x to the right and y up. */
public record Point(double x, double y) {}

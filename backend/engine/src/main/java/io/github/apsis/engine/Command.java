package io.github.apsis.engine;

import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;

/** A wish to change a world between two ticks: beside {@link World#step()} the only way to do so. */
public sealed interface Command {
    /** Adds a body. Refused when the world is full or the place lies outside its edge. */
    record AddBody(BodyDef body) implements Command {}

    /** Removes a body. Refused when it is not there. */
    record RemoveBody(BodyId body) implements Command {}

    /** Orders a ship to a point, where it stops. Refused for what is not a ship, and for a point outside the world. */
    record SeekTarget(BodyId ship, double x, double y) implements Command {}

    /** Ends a ship's order: it wanders again. */
    record Wander(BodyId ship) implements Command {}
}

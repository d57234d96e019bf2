package io.github.apsis.engine.body;

/** What a body is to the people who watch. Only a {@link #SHIP} steers itself; the physics treats all alike. */
public enum BodyKind {
    PLANET,
    ASTEROID,
    SHIP
}

package io.github.apsis.engine.body;

/** Whether forces and impulses move a body. */
public enum Mobility {
    /** Moves under forces and impulses. */
    FREE,
    /** Stays where it is: infinite mass to forces and impulses, but it still attracts with its own mass. */
    FIXED
}

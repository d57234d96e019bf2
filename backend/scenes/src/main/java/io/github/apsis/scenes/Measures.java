package io.github.apsis.scenes;

/** Which conserved quantities a scene asks to have measured while it runs. */
public enum Measures {
    NONE,
    ENERGY_AND_MOMENTUM
}

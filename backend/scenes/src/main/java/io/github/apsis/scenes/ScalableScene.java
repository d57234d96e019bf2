package io.github.apsis.scenes;

/** A scene that makes sense with any number of bodies. */
public interface ScalableScene extends Scene {
    /** The same scene with so many bodies in all. */
    Scene withBodies(int count);
}

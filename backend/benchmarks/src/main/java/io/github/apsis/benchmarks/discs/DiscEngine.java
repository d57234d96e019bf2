package io.github.apsis.benchmarks.discs;

/** The least that an engine must offer to run a scene. Discs are numbered in the order of the scene. */
public interface DiscEngine {
    /** Advances by one tick of the scene. */
    void step();

    double x(int i);

    double y(int i);

    double vx(int i);

    double vy(int i);
}

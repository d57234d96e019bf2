package io.github.apsis.benchmarks.steering;

/** Steers all ships of one run. */
interface Pilot {
    /** Sees where everything is; not part of what steering costs. */
    void look(SceneState state);

    /** Writes what every live ship's engine shall do, from what was seen alone. */
    void steer(SceneState state);
}

package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;

/** What a ship would do if it were alone: a velocity. Who writes one changes nothing of the bodies but that ship's heading. */
public interface Preference {
    /** Fills in the velocity that the ship in slot {@code i} would like to have. */
    void prefer(Bodies bodies, int i, long tick, double dt, SteeringVector velocity);
}

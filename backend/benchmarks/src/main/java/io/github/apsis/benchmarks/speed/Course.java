package io.github.apsis.benchmarks.speed;

import java.util.List;

/** Something that steps, and knows what is wrong with it. */
interface Course {
    /** What is measured, and nothing else. */
    void step();

    /** Looks at the state between two batches, outside the measured time. */
    default void look() {}

    /** The errors, after the last step. */
    List<Finding> findings();

    /** Nobody steps it any more. */
    default void end() {}
}

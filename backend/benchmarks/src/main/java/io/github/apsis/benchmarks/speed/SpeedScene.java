package io.github.apsis.benchmarks.speed;

/** A scene that is run in several sizes. */
interface SpeedScene {
    /** As {@code --scene} and the table have it. */
    String name();

    /** One sentence for the page: what the scene is and what its errors measure. */
    String description();

    /** Whether several threads can step its worlds. */
    default boolean usesThreads() {
        return false;
    }

    /** Runs it in all sizes and engines. */
    void run(Bench bench);
}

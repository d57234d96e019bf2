package io.github.apsis.engine.force;

/** Who wants to know how bodies are accelerated. */
interface Pulled {
    /** Called once for every body, by its slot, in any order and from any thread of a team. */
    void accelerate(int slot, double ax, double ay);
}

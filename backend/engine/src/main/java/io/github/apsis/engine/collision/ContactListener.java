package io.github.apsis.engine.collision;

/** Hears of every bounce, in the order of their times: for tests that count collisions and for those who log them. */
public interface ContactListener {
    /**
     * Two bodies have bounced, or a body and a wall. The world must not be changed meanwhile.
     *
     * @param time since the world began
     * @param first id of a body
     * @param second id of the other body, or −1, −2, … for a wall: in the order in which a boundary lists its half-planes, of a
     *     box left, right, bottom, top
     * @param closingSpeed along the line of centres just before, length / time
     * @param impulse on each of the two, mass · length / time
     */
    void bounced(double time, long first, long second, double closingSpeed, double impulse);
}

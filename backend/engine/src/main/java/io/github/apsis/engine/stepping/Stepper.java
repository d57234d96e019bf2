package io.github.apsis.engine.stepping;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.collision.ContactListener;

/** How one tick advances the bodies. */
public interface Stepper {
    /** Advances by a tick that begins at this time since the world began. */
    void step(Bodies bodies, double time);

    /** Tells a listener of every bounce from now on. */
    void onBounce(ContactListener listener);

    /** Whether what has left the range of numbers must be gone before a tick: its speed has no power, and no wall holds it. */
    boolean needsNumbers();

    /** The time that the bodies are behind the clock, since a tick needed more steps than one may have. */
    double lostTime();

    /** How often two points have fallen into each other and were turned round. */
    long pointBounces();
}

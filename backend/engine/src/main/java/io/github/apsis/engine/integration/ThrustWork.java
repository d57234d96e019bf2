package io.github.apsis.engine.integration;

import io.github.apsis.engine.body.Bodies;

/** The work of a constant thrust over a tick, F · (x1 − x0), whatever happens on the way. */
public final class ThrustWork {
    private double[] startX = new double[0];
    private double[] startY = new double[0];

    /** Remembers where ships are at the beginning of a tick. */
    public void begin(Bodies bodies) {
        if (startX.length < bodies.count()) {
            startX = new double[bodies.count()];
            startY = new double[bodies.count()];
        }
        bodies.copyPositions(startX, startY);
    }

    /** Books the work at the end of the tick. */
    public void book(Bodies bodies) {
        for (int i : bodies.ships()) {
            if (!bodies.isFixed(i)) {
                double fx = bodies.thrustX(i);
                double fy = bodies.thrustY(i);
                bodies.ledger().bookEnergy(fx * (bodies.x(i) - startX[i]) + fy * (bodies.y(i) - startY[i]));
            }
        }
    }
}

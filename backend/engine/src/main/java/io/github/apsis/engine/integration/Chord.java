package io.github.apsis.engine.integration;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.force.Forces;

/**
 * Any integrator, in a world with contacts: its tick is drawn as the parabola with the same ends.
 *
 * <pre>
 *   v̄ = (x1 − x0)/dt     a = (v1 − v0)/dt     v1 = v̄ + a dt/2 + O(dt²)
 * </pre>
 *
 * <p>A body that meets nothing ends the tick with exactly the bits that the integrator gave it. One whose path was bent keeps
 * the bend and half the change of velocity: its contact is as exact as with Verlet, of order two in the tick.
 */
public final class Chord implements PathIntegrator {
    private final Integrator integrator;

    private double[] startX = new double[0];
    private double[] startY = new double[0];
    private double[] startVx = new double[0];
    private double[] startVy = new double[0];
    private double[] end = new double[0]; // vx, its low part, vy, its low part of every body
    private double[] mean = new double[0]; // vx, vy of every body

    public Chord(Integrator integrator) {
        this.integrator = integrator;
    }

    @Override
    public void move(Bodies bodies, Forces forces, double dt) {
        int count = bodies.count();
        if (count > startX.length) {
            grow(Math.max(count, 2 * startX.length));
        }
        bodies.copyPositions(startX, startY);
        bodies.copyVelocities(startVx, startVy);
        integrator.advance(bodies, forces, dt);
        for (int i = 0; i < count; i++) {
            draw(bodies, i, dt);
        }
    }

    private void draw(Bodies bodies, int i, double dt) {
        end[4 * i] = bodies.vx(i);
        end[4 * i + 1] = bodies.vxLow(i);
        end[4 * i + 2] = bodies.vy(i);
        end[4 * i + 3] = bodies.vyLow(i);
        mean[2 * i] = (bodies.x(i) - startX[i]) / dt;
        mean[2 * i + 1] = (bodies.y(i) - startY[i]) / dt;
        double ax = (bodies.vx(i) - startVx[i]) / dt;
        double ay = (bodies.vy(i) - startVy[i]) / dt;
        double thrustX = bodies.thrustX(i) * bodies.inverseMass(i);
        double thrustY = bodies.thrustY(i) * bodies.inverseMass(i);
        bodies.setVelocity(i, mean[2 * i], 0, mean[2 * i + 1], 0);
        bodies.setAcceleration(i, ax - thrustX, ay - thrustY); // who looks along the path adds the thrust
    }

    @Override
    public void finish(Bodies bodies, Forces forces, double dt) {
        for (int i = 0; i < bodies.count(); i++) {
            double bendX = bodies.vx(i) - mean[2 * i];
            double bendY = bodies.vy(i) - mean[2 * i + 1];
            if (bendX == 0 && bendY == 0) {
                bodies.setVelocity(i, end[4 * i], end[4 * i + 1], end[4 * i + 2], end[4 * i + 3]);
            } else {
                bodies.setVelocity(
                        i,
                        bodies.vx(i) + 0.5 * (end[4 * i] - startVx[i]),
                        0,
                        bodies.vy(i) + 0.5 * (end[4 * i + 2] - startVy[i]),
                        0);
            }
        }
    }

    private void grow(int capacity) {
        startX = new double[capacity];
        startY = new double[capacity];
        startVx = new double[capacity];
        startVy = new double[capacity];
        mean = new double[2 * capacity];
        end = new double[4 * capacity];
    }
}

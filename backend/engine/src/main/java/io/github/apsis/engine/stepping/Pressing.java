package io.github.apsis.engine.stepping;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.collision.ContactSet;
import io.github.apsis.engine.integration.DensePath;
import io.github.apsis.engine.integration.TaylorStep;

/**
 * How hard partners of a contact are pressed together, on the paths of a step:
 *
 * <pre>
 *   −g'' = −n · (a_2 − a_1) − (|w|² − (w·n)²) / |d|
 * </pre>
 *
 * <p>with w the relative velocity: what slides over something round must be held to it.
 */
final class Pressing {
    /** A contact is at rest when its flight until the next bounce would be shorter than this share of a tick. */
    private static final double SHORTEST_FLIGHT = 1e-3;

    /** A speed below this share of those it is the difference of is rounding. */
    private static final double ROUNDING = 1e-14;

    private final TaylorStep step;
    private final DensePath path;
    private final double dt;

    Pressing(TaylorStep step, double dt) {
        this.step = step;
        this.path = step.newPath();
        this.dt = dt;
    }

    /** Acceleration with which the forces of a time t press the k-th contact; negative where they part it. */
    double acceleration(Bodies bodies, ContactSet contacts, int k, double t) {
        int a = contacts.first(k);
        int b = contacts.second(k);
        double nx = contacts.normalX(k);
        double ny = contacts.normalY(k);
        double wx = -bodies.vx(a);
        double wy = -bodies.vy(a);
        if (b < 0) {
            step.copyPath(a, path);
            path.lookAt(t);
            return path.ax() * nx + path.ay() * ny;
        }
        wx += bodies.vx(b);
        wy += bodies.vy(b);
        step.copyPath(a, b, path);
        path.lookAt(t);
        double across = wx * ny - wy * nx;
        double distance = contacts.distance(k);
        double outwards = distance > 0 ? across * across / distance : 0;
        return -(path.ax() * nx + path.ay() * ny) - outwards;
    }

    /**
     * The speed below which a contact is at rest that is pressed so hard at a time t: a · flight / 2. What is a rounding of the
     * speeds that partners have, or get from the forces in a tick, is rest as well.
     */
    double gentleSpeed(Bodies bodies, ContactSet contacts, int k, double pressed, double t) {
        int a = contacts.first(k);
        int b = contacts.second(k);
        double speeds = speed(bodies, a, t) + (b < 0 ? 0 : speed(bodies, b, t));
        return 0.5 * Math.max(0, pressed) * SHORTEST_FLIGHT * dt + ROUNDING * speeds;
    }

    private double speed(Bodies bodies, int i, double t) {
        step.copyPath(i, path);
        path.lookAt(t);
        return Math.abs(bodies.vx(i)) + Math.abs(bodies.vy(i)) + dt * (Math.abs(path.ax()) + Math.abs(path.ay()));
    }

    /** The work of forces, without thrust, on a body that is shifted at a time t. */
    double work(Bodies bodies, int i, double t, double shiftX, double shiftY) {
        step.copyPath(i, path);
        path.lookAt(t);
        double fx = bodies.mass(i) * path.ax() - bodies.thrustX(i);
        double fy = bodies.mass(i) * path.ay() - bodies.thrustY(i);
        return fx * shiftX + fy * shiftY;
    }
}

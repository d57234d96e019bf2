package io.github.apsis.engine;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.engine.math.Vec2;
import java.util.Arrays;
import java.util.Optional;

/**
 * An immutable copy of all bodies after one tick. Bodies are numbered 0 … count − 1 in the order in which they were added;
 * {@link #indexOf} finds one by its id.
 */
public final class WorldSnapshot {
    private final long tick;
    private final double time;
    private final long[] ids;
    private final BodyKind[] kinds;
    private final double[] x;
    private final double[] y;
    private final double[] xLow;
    private final double[] yLow;
    private final double[] vx;
    private final double[] vy;
    private final double[] ax;
    private final double[] ay;
    private final double[] mass;
    private final double[] radius;
    private final double[] thrust;
    private final double[] targetX;
    private final double[] targetY;

    WorldSnapshot(long tick, double time, Bodies bodies) {
        this.tick = tick;
        this.time = time;
        int n = bodies.count();
        ids = new long[n];
        kinds = new BodyKind[n];
        x = new double[n];
        y = new double[n];
        xLow = new double[n];
        yLow = new double[n];
        vx = new double[n];
        vy = new double[n];
        ax = new double[n];
        ay = new double[n];
        mass = new double[n];
        radius = new double[n];
        thrust = new double[n];
        targetX = new double[n];
        targetY = new double[n];
        for (int i = 0; i < n; i++) {
            ids[i] = bodies.idValue(i);
            kinds[i] = bodies.kind(i);
            x[i] = bodies.x(i);
            y[i] = bodies.y(i);
            xLow[i] = bodies.xLow(i);
            yLow[i] = bodies.yLow(i);
            vx[i] = bodies.vx(i);
            vy[i] = bodies.vy(i);
            ax[i] = bodies.ax(i) + bodies.thrustX(i) * bodies.inverseMass(i);
            ay[i] = bodies.ay(i) + bodies.thrustY(i) * bodies.inverseMass(i);
            mass[i] = bodies.mass(i);
            radius[i] = bodies.radius(i);
            thrust[i] =
                    bodies.isShip(i) ? new Vec2(bodies.thrustX(i), bodies.thrustY(i)).length() / bodies.maxForce(i) : 0;
            targetX[i] = bodies.targetX(i);
            targetY[i] = bodies.targetY(i);
        }
    }

    /**
     * The distance of two bodies' centres, from more digits than their positions show: the adaptive method carries what lies
     * below the last bit of a position, which is 1e-7 of a length when a world stands 1e9 lengths from its origin.
     */
    public double distance(int i, int j) {
        return Math.hypot(x[j] - x[i] + (xLow[j] - xLow[i]), y[j] - y[i] + (yLow[j] - yLow[i]));
    }

    /** Ticks since the world began. */
    public long tick() {
        return tick;
    }

    /** tick · dt, in the time unit of the scene. */
    public double time() {
        return time;
    }

    public int count() {
        return ids.length;
    }

    /** The index of a body, or a negative number when it is not there. */
    public int indexOf(BodyId body) {
        return Arrays.binarySearch(ids, body.value());
    }

    public BodyId id(int i) {
        return new BodyId(ids[i]);
    }

    public BodyKind kind(int i) {
        return kinds[i];
    }

    public double x(int i) {
        return x[i];
    }

    public double y(int i) {
        return y[i];
    }

    public double vx(int i) {
        return vx[i];
    }

    public double vy(int i) {
        return vy[i];
    }

    /** Acceleration by all forces, thrust included. */
    public double ax(int i) {
        return ax[i];
    }

    public double ay(int i) {
        return ay[i];
    }

    public double mass(int i) {
        return mass[i];
    }

    public double radius(int i) {
        return radius[i];
    }

    /** The force of a ship's engine as a share of its maximum, 0 to 1; 0 for what is not a ship. */
    public double thrust(int i) {
        return thrust[i];
    }

    /** Where a ship's order leads; empty without an order. */
    public Optional<Vec2> target(int i) {
        return Double.isNaN(targetX[i]) ? Optional.empty() : Optional.of(new Vec2(targetX[i], targetY[i]));
    }
}

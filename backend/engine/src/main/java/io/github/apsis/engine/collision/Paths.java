package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import java.util.Arrays;

/**
 * The paths of all bodies through the present tick: for each the parabola from its last impact, or from the start of the
 * tick, to where it stands now.
 *
 * <pre>
 *   x(t) = xs + (x1 − xs) (t − ts)/(dt − ts) − a (t − ts)(dt − t)/2        v(t) = v̄ + a (t − dt/2)
 * </pre>
 *
 * where x1 is the position in {@link Bodies}, v̄ the velocity there, which is the mean over the whole tick, and a the
 * acceleration the path was drawn with.
 */
final class Paths {
    private double dt;
    private double[] startX = new double[16];
    private double[] startY = new double[16];
    private int[] bend = new int[16]; // place in the list of bent paths + 1, 0 for a path that begins with the tick

    // The paths that have been bent in this tick.
    private int bentCount;
    private int[] bent = new int[16]; // their bodies
    private double[] startTime = new double[16];
    private int[] impacts = new int[16];

    /** Remembers where every body stands, before it moves. */
    void begin(Bodies bodies, double tick) {
        dt = tick;
        int count = bodies.count();
        if (count > startX.length) {
            int capacity = Math.max(count, startX.length + startX.length / 8);
            startX = new double[capacity];
            startY = new double[capacity];
            bend = new int[capacity];
        } else {
            straighten();
        }
        bentCount = 0;
        bodies.copyPositions(startX, startY);
    }

    private void straighten() {
        for (int k = 0; k < bentCount; k++) {
            bend[bent[k]] = 0;
        }
    }

    /** Finds circles around the paths, none of which has been bent: see {@link Bodies#encloseMoves}. */
    void enclose(Bodies bodies, double[] centreX, double[] centreY, double[] reach) {
        bodies.encloseMoves(startX, startY, room(dt), centreX, centreY, reach);
    }

    /**
     * Time², by which an acceleration is multiplied: a parabola leaves its chord by a T²/8 at most, and a body that is stopped by
     * another is a dt² from where it would be.
     */
    double room(double length) {
        return length * length / 8 + dt * dt;
    }

    double dt() {
        return dt;
    }

    double startX(int i) {
        return startX[i];
    }

    double startY(int i) {
        return startY[i];
    }

    double startTime(int i) {
        return bend[i] == 0 ? 0 : startTime[bend[i] - 1];
    }

    /** How many paths have been bent in this tick. */
    int bentCount() {
        return bentCount;
    }

    /** The body whose path was the {@code k}-th to be bent for the first time. */
    int bent(int k) {
        return bent[k];
    }

    /** How often the path has been bent in this tick, never for a wall; tells whether a prediction is out of date. */
    int impacts(int i) {
        return i < 0 || bend[i] == 0 ? 0 : impacts[bend[i] - 1];
    }

    /** The larger of two. */
    int mostImpacts(int a, int b) {
        return Math.max(impacts(a), impacts(b));
    }

    static double accelerationX(Bodies bodies, int i) {
        return bodies.ax(i) + bodies.thrustAccelerationX(i);
    }

    static double accelerationY(Bodies bodies, int i) {
        return bodies.ay(i) + bodies.thrustAccelerationY(i);
    }

    /** The larger of the accelerations of two partners, of which the second may be a wall. */
    static double acceleration(Bodies bodies, int a, int b) {
        double ax = accelerationX(bodies, a);
        double ay = accelerationY(bodies, a);
        double larger = ax * ax + ay * ay;
        if (b >= 0) {
            ax = accelerationX(bodies, b);
            ay = accelerationY(bodies, b);
            larger = Math.max(larger, ax * ax + ay * ay);
        }
        return Math.sqrt(larger);
    }

    /** A bound on the distance of the path from its chord: a T²/8. */
    double bulge(Bodies bodies, int i) {
        double length = dt - startTime(i);
        return (Math.abs(accelerationX(bodies, i)) + Math.abs(accelerationY(bodies, i))) * length * length / 8;
    }

    double xAt(Bodies bodies, int i, double t) {
        return at(startX[i], bodies.x(i), startTime(i), accelerationX(bodies, i), t);
    }

    double yAt(Bodies bodies, int i, double t) {
        return at(startY[i], bodies.y(i), startTime(i), accelerationY(bodies, i), t);
    }

    private double at(double start, double end, double from, double acceleration, double t) {
        return t == from
                ? start
                : start + (end - start) * ((t - from) / (dt - from)) - 0.5 * acceleration * (t - from) * (dt - t);
    }

    double vxAt(Bodies bodies, int i, double t) {
        return bodies.vx(i) + accelerationX(bodies, i) * (t - 0.5 * dt);
    }

    double vyAt(Bodies bodies, int i, double t) {
        return bodies.vy(i) + accelerationY(bodies, i) * (t - 0.5 * dt);
    }

    /** Bends the path of a body at time t by a change of velocity: it ends elsewhere. */
    void bend(Bodies bodies, int i, double t, double dvx, double dvy) {
        double x = xAt(bodies, i, t);
        double y = yAt(bodies, i, t);
        bodies.push(i, dvx, dvy);
        bodies.shift(i, dvx * (dt - t), dvy * (dt - t));
        startX[i] = x;
        startY[i] = y;
        if (bend[i] == 0) {
            list(i);
        }
        startTime[bend[i] - 1] = t;
        impacts[bend[i] - 1]++;
    }

    private void list(int i) {
        if (bentCount == bent.length) {
            bent = Arrays.copyOf(bent, 2 * bentCount);
            startTime = Arrays.copyOf(startTime, 2 * bentCount);
            impacts = Arrays.copyOf(impacts, 2 * bentCount);
        }
        impacts[bentCount] = 0;
        bent[bentCount++] = i;
        bend[i] = bentCount;
    }
}

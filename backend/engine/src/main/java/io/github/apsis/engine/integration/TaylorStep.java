package io.github.apsis.engine.integration;

import io.github.apsis.engine.body.Bodies;

/**
 * One step of {@link GravitySeries}: the paths of all bodies from the present moment on, as far as they keep each separation to
 * the tolerance. Times are counted from that moment.
 */
public final class TaylorStep {
    /**
     * Of figure-eight and Kepler orbits at all tolerances from 1e-6 to 1e-16, orders 17 and 19 were the cheapest at equal error;
     * 9 took three times as long, even orders had ten times the error of the odd one below.
     */
    private static final int ORDER = 19;

    private static final double LONGEST = 4096; // ticks
    private static final double BOUNCE = 1e-11; // ticks; where a shorter step is needed, points collide

    private final GravitySeries series;
    private final double share;
    private final double mostBend;

    private double unit = Double.NaN; // of time for the next expansion
    private double length;
    private double booked; // until when
    private long bounces;

    /**
     * @param g length³ / (mass · time²)
     * @param softening of Plummer, length
     * @param fieldX uniform acceleration, length / time²
     * @param tolerance error of a step relative to each separation, 1e-16 to 1e-2
     */
    public TaylorStep(double g, double softening, double fieldX, double fieldY, double tolerance) {
        // Shorter steps are more steps, and their errors add up: with the power, a run's error falls faster than the
        // tolerance.
        this.share = StrictMath.pow(tolerance, 1.2);
        // Rounding grows with the root of a step's length: at the finest tolerance no step turns a pair by more than a
        // fourteenth of a revolution. Coarser ones need not care.
        this.mostBend = 0.1 * StrictMath.pow(share / StrictMath.pow(1e-16, 1.2), 2.0 / ORDER);
        this.series = new GravitySeries(g, softening, fieldX, fieldY, ORDER);
    }

    /** Starts a step at the present state, in a world of such ticks. */
    public void begin(Bodies bodies, double dt) {
        if (Double.isNaN(unit)) {
            unit = inRange(series.shortestTime(bodies), dt);
        }
        double reach = reach(bodies, dt);
        if (reach < BOUNCE * dt && series.bounceClosest(bodies)) {
            bounces++;
            reach = reach(bodies, dt);
        }
        reach = inRange(reach, dt);
        float round = (float) reach; // few bits, so that the products with it and the sums of it are nearly exact
        length = round > 0 ? round : reach;
        booked = 0;
    }

    private double reach(Bodies bodies, double dt) {
        series.expand(bodies, unit);
        double reach = series.reach(share, mostBend);
        if (!(reach > 1e-6 * unit)) { // the unit was so wrong that the coefficients may have left the numbers
            unit = inRange(series.shortestTime(bodies), dt);
            series.expand(bodies, unit);
            reach = series.reach(share, mostBend);
        }
        unit = inRange(reach, dt);
        return reach;
    }

    private static double inRange(double time, double dt) {
        return Math.max(1e-150, Math.min(time, LONGEST * dt));
    }

    /** How far it reaches, time. */
    public double length() {
        return length;
    }

    /** Puts all free bodies where they are at a time t, and books what came from outside until then. */
    public void place(Bodies bodies, double t, double low) {
        series.place(bodies, t + low);
        series.bookOutside(bodies.ledger(), booked, t);
        booked = t;
    }

    /** Room for a path. */
    public DensePath newPath() {
        return series.newPath();
    }

    /** Copies the path of body j as it is seen from body i. */
    public void copyPath(int i, int j, DensePath path) {
        series.copyPath(i, j, path);
    }

    /** Copies the path of a body. */
    public void copyPath(int i, DensePath path) {
        series.copyPath(i, path);
    }

    /** How often two points have fallen into each other and were turned round. */
    public long bounces() {
        return bounces;
    }
}

package io.github.apsis.engine.integration;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.force.Forces;

/**
 * Newton's gravity by Taylor series of high order, with steps as long as the motion allows: a step spans many ticks where
 * bodies are far apart, and a tick many steps where they pass close.
 *
 * <p>The length of a step is set before it is taken, from the last two terms of {@link GravitySeries}, for the pair that needs
 * the shortest: each separation is kept to the tolerance relative to itself, wherever the world stands and however fast it
 * moves. Ticks inside a step are read off its polynomial. Positions, velocities and the accelerations are carried in pairs of
 * doubles, so that rounding grows like a random walk (Brouwer 1937, AJ 46, 149) that starts below the last bit.
 *
 * <p>It knows gravity, uniform fields and thrust, which is constant through a tick. Two points that fall into each other
 * bounce, see {@link GravitySeries#bounceClosest}. A tick that needs more than {@value #MOST_STEPS} steps is not finished: the
 * time that is left of it is lost and counted.
 */
public final class AdaptiveTaylor implements Integrator {
    /** The most bodies it is made for: each pair keeps its series, 650 bytes and 0.4 µs a step. */
    public static final int MOST_BODIES = 256;

    /**
     * Of figure-eight and Kepler orbits at all tolerances from 1e-6 to 1e-16, orders 17 and 19 were the cheapest at equal error;
     * 9 took three times as long, even orders had ten times the error of the odd one below.
     */
    private static final int ORDER = 19;

    private static final int MOST_STEPS = 50_000; // of one tick
    private static final double LONGEST_STEP = 4096; // ticks
    private static final double BOUNCE_STEP = 1e-11; // ticks; where a shorter step is needed, points collide

    private final GravitySeries series;
    private final double share;
    private final double mostBend;

    private long revision = -1;
    private double unit = 1; // of time for the next expansion
    private double step;
    private double elapsed; // from the moment of the series to the present
    private double elapsedLow;
    private double booked; // until when, from the moment of the series
    private double[] startX = new double[0];
    private double[] startY = new double[0];

    private long bounces;
    private double lostTime;

    /**
     * @param g length³ / (mass · time²)
     * @param softening of Plummer, length
     * @param fieldX uniform acceleration, length / time²
     * @param tolerance error of a step relative to each separation, 1e-16 to 1e-2
     */
    public AdaptiveTaylor(double g, double softening, double fieldX, double fieldY, double tolerance) {
        // Shorter steps are more steps, and their errors add up: with the power, a run's error falls faster than the
        // tolerance.
        this.share = StrictMath.pow(tolerance, 1.2);
        // Rounding grows with the root of a step's length: at the finest tolerance no step turns a pair by more than a
        // fourteenth of a revolution. Coarser ones need not care.
        this.mostBend = 0.1 * StrictMath.pow(share / StrictMath.pow(1e-16, 1.2), 2.0 / ORDER);
        this.series = new GravitySeries(g, softening, fieldX, fieldY, ORDER);
    }

    @Override
    public void advance(Bodies bodies, Forces forces, double dt) {
        boolean ships = bodies.ships().length > 0;
        if (bodies.revision() != revision || ships) {
            unit = revision < 0 ? inRange(series.shortestTime(bodies), dt) : unit;
            elapsed = 0;
            elapsedLow = 0;
            begin(bodies, dt);
        }
        if (ships) {
            bodies.copyPositions(room(startX, bodies), startY);
        }
        double target = elapsed + dt;
        double targetLow = elapsedLow + ((elapsed - target) + dt);
        int steps = 0;
        while (target > step) {
            series.place(bodies, step);
            bookOutside(bodies, step);
            if (steps++ == MOST_STEPS) {
                lostTime += target - step;
                target = 0;
                targetLow = 0;
                begin(bodies, dt);
                break;
            }
            double left = target - step;
            targetLow += (target - left) - step;
            target = left;
            begin(bodies, dt);
        }
        series.place(bodies, target + targetLow);
        bookOutside(bodies, target);
        elapsed = target;
        elapsedLow = targetLow;
        if (ships) {
            bookThrust(bodies);
        }
        revision = bodies.revision();
    }

    /** Starts a step at the present state. */
    private void begin(Bodies bodies, double dt) {
        double length = reach(bodies, dt);
        if (length < BOUNCE_STEP * dt && series.bounceClosest(bodies)) {
            bounces++;
            length = reach(bodies, dt);
        }
        length = inRange(length, dt);
        float round = (float) length; // few bits, so that the products with it and the sums of it are nearly exact
        step = round > 0 ? round : length;
        booked = 0;
    }

    private double reach(Bodies bodies, double dt) {
        series.expand(bodies, unit);
        double length = series.reach(share, mostBend);
        if (!(length > 1e-6 * unit)) { // the unit was so wrong that the coefficients may have left the numbers
            unit = inRange(series.shortestTime(bodies), dt);
            series.expand(bodies, unit);
            length = series.reach(share, mostBend);
        }
        unit = inRange(length, dt);
        return length;
    }

    private static double inRange(double time, double dt) {
        return Math.max(1e-150, Math.min(time, LONGEST_STEP * dt));
    }

    private void bookOutside(Bodies bodies, double t) {
        series.bookOutside(bodies.ledger(), booked, t);
        booked = t;
    }

    private double[] room(double[] column, Bodies bodies) {
        if (column.length >= bodies.count()) {
            return column;
        }
        startX = new double[bodies.count()];
        startY = new double[bodies.count()];
        return startX;
    }

    private void bookThrust(Bodies bodies) {
        for (int i : bodies.ships()) {
            if (!bodies.isFixed(i)) {
                double fx = bodies.thrustX(i);
                double fy = bodies.thrustY(i);
                bodies.ledger().bookEnergy(fx * (bodies.x(i) - startX[i]) + fy * (bodies.y(i) - startY[i]));
            }
        }
    }

    /** How often two points have fallen into each other and were turned round. */
    public long bounces() {
        return bounces;
    }

    /** The time that was lost in ticks which needed too many steps. */
    public double lostTime() {
        return lostTime;
    }
}

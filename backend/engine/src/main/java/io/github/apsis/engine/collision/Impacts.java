package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.spatial.Workspace;
import org.jspecify.annotations.Nullable;

/**
 * The bounces of a tick, each at its true time and with its true normal, in the order of their times.
 *
 * <p>An impulse j = (1+e) c / (1/m1 + 1/m2) along the line of centres turns the closing speed c into e c. Both paths bend
 * there, so both bodies look for their next partner from there on. A contact whose closing speed is no more than what the
 * forces give in two ticks is no bounce: e is 0 there, and what touches already is left to {@link RestingContacts}.
 */
final class Impacts {
    /** Impacts that differ by this share of a tick are looked at more closely: they may be one moment. Speeds that differ by it do not belong together. */
    private static final double SAME = 1e-9;

    /** A gap of this share of coordinates and radii is none: positions are sums of thousands of ticks. */
    private static final double ROUNDING = 1e-12;

    private static final int FEWEST_BOUNCES = 8;
    private static final int MOST_BOUNCES = 64;
    private static final int MOST_ELASTIC_BOUNCES = 100_000;
    private static final int MOST_EXACT_BOUNCES = 1000;

    private final double restitution;
    private final ContactMode mode;
    private final int mostBounces; // of a body in a tick
    private final double wallRestitution;
    private final Paths paths;
    private final Approach approach;
    private final ImpactQueue queue = new ImpactQueue();
    private final ImpactPredictor predictor;
    private final SimultaneousImpacts moment = new SimultaneousImpacts();
    private @Nullable ContactListener listener;
    private double start; // of the tick, time since the world began

    Impacts(
            double restitution,
            double wallRestitution,
            @Nullable BroadPhase broadPhase,
            @Nullable WallSet walls,
            @Nullable Period period,
            Paths paths,
            Approach approach,
            Touching touching,
            LyingHeaps lying,
            ContactMode mode,
            Workspace workspace) {
        this.restitution = restitution;
        this.mode = mode;
        this.mostBounces = mostBounces(mode, Math.max(restitution, walls == null ? 0 : wallRestitution));
        this.wallRestitution = wallRestitution;
        this.paths = paths;
        this.approach = approach;
        this.predictor = new ImpactPredictor(
                broadPhase, walls, period, paths, approach, queue, touching, lying, mode, 2 * mostBounces, workspace);
    }

    /**
     * A body that is hit more often in one tick is in a collapse: with e &lt; 1 infinitely many bounces may take a finite time.
     * From then on its contacts of this tick are inelastic, and after as many again they are at rest. So many bounces take all
     * but a hundredth of a speed, twice over, and exact contacts take a thousand; without loss there is no collapse, only a bullet in a box.
     */
    private static int mostBounces(ContactMode mode, double e) {
        if (e == 1) {
            return MOST_ELASTIC_BOUNCES;
        }
        if (mode == ContactMode.EXACT) {
            return MOST_EXACT_BOUNCES;
        }
        double bounces = e > 0 ? 2 * StrictMath.log(0.01) / StrictMath.log(e) : 0;
        return (int) Math.max(FEWEST_BOUNCES, Math.min(MOST_BOUNCES, bounces));
    }

    void onBounce(ContactListener newListener) {
        listener = newListener;
    }

    /** Remembers when a tick begins. */
    void begin(double time) {
        start = time;
    }

    /** Resolves all bounces of the tick; fills the list of contacts at rest. */
    void resolve(Bodies bodies) {
        predictor.predictAll(bodies);
        while (!queue.isEmpty()) {
            if (!isCurrent()) {
                queue.pop(); // it was predicted anew when a path was bent
                continue;
            }
            double t = queue.time();
            collectMoment(bodies, t);
            measureMoment(bodies, t);
            if (moment.size() == 1) {
                bounce(bodies, t);
            } else {
                bounceTogether(bodies, t);
            }
        }
    }

    /** Lists what bodies have been held off into; see {@link ImpactPredictor#findIntruders}. */
    boolean findIntruders(Bodies bodies, HeldBodies held) {
        return predictor.findIntruders(bodies, held);
    }

    private boolean isCurrent() {
        return queue.firstVersion() == paths.impacts(queue.first())
                && queue.secondVersion() == paths.impacts(queue.second());
    }

    /** Takes the earliest impact, and those that share a body with it and touch by then but for rounding. */
    private void collectMoment(Bodies bodies, double t) {
        moment.clear(bodies.count());
        int first = queue.first();
        int second = queue.second();
        moment.add(first, second);
        queue.pop();
        if (queue.isEmpty() || queue.time() - t > SAME * paths.dt()) {
            return; // by far the usual case
        }
        approach.measure(bodies, first, second, t);
        double closing = approach.closingSpeed();
        while (!queue.isEmpty() && queue.time() - t <= SAME * paths.dt()) {
            int a = queue.first();
            int b = queue.second();
            if (isCurrent()) {
                if (!moment.touches(a) && !moment.touches(b) || !touch(bodies, a, b, t, closing)) {
                    return; // another moment, or another place
                }
                moment.add(a, b);
            }
            queue.pop();
        }
    }

    /** Whether two touch at time t, and close at a speed beside which another is not rounding, nor rounding beside it. */
    private boolean touch(Bodies bodies, int a, int b, double t, double otherSpeed) {
        approach.measure(bodies, a, b, t);
        double digits = Math.abs(bodies.x(a)) + Math.abs(bodies.y(a)) + bodies.radius(a);
        return approach.contact().gap <= ROUNDING * (b < 0 ? digits : digits + bodies.radius(b))
                && approach.closingSpeed() > SAME * otherSpeed
                && otherSpeed > SAME * approach.closingSpeed();
    }

    private void measureMoment(Bodies bodies, double t) {
        for (int k = 0; k < moment.size(); k++) {
            int a = moment.first(k);
            int b = moment.second(k);
            approach.measureImpact(bodies, a, b, t);
            boolean inelastic = paths.mostImpacts(a, b) >= mostBounces || approach.isGentle(bodies, a, b);
            double e = inelastic ? 0 : b < 0 ? wallRestitution : restitution;
            moment.measured(k, approach, e);
        }
    }

    private void bounce(Bodies bodies, double t) {
        int a = moment.first(0);
        int b = moment.second(0);
        boolean hops = mode == ContactMode.EXACT && approach.isGentle(bodies, a, b);
        if (hops) {
            moment.measured(0, approach, approach.hop(bodies, a, b, paths.dt() - t) / approach.closingSpeed());
        }
        double inverseMass = bodies.inverseMass(a) + (b < 0 ? 0 : bodies.inverseMass(b));
        double closing = moment.closingSpeed(0);
        double impulse = moment.bounce(0) * closing / inverseMass;
        bodies.ledger().bookEnergy(impulse * (0.5 * impulse * inverseMass - closing));
        if (!hops) {
            tell(bodies, 0, t, impulse);
        }
        pass(bodies, 0, t, impulse);
        // Not impulse · n: a million bounces of rounding in the root of n are 1e-12 of the energy.
        double rate = moment.bounce(0) * approach.closingRate() / inverseMass;
        double px = rate * approach.contact().lineX;
        double py = rate * approach.contact().lineY;
        bend(bodies, a, t, -px * bodies.inverseMass(a), -py * bodies.inverseMass(a));
        if (hops) {
            predictor.hop(bodies, a, b);
        }
        if (b >= 0) {
            bend(bodies, b, t, px * bodies.inverseMass(b), py * bodies.inverseMass(b));
        }
        predictor.predictNext(bodies, a, b);
        if (b >= 0) {
            predictor.predictNext(bodies, b, a);
            if (moment.bounce(0) == 1 || predictor.mayMeetAgain()) {
                predictor.predictAgain(bodies, a, b);
            }
        }
    }

    private void bounceTogether(Bodies bodies, double t) {
        moment.solve(bodies);
        bodies.ledger().bookEnergy(moment.work());
        for (int k = 0; k < moment.size(); k++) {
            tell(bodies, k, t, moment.impulse(k));
            pass(bodies, k, t, moment.impulse(k));
        }
        for (int number = 1; number < moment.numbers(); number++) {
            bookMassless(bodies, number, t);
            bend(bodies, moment.slot(number), t, moment.pushX(number), moment.pushY(number));
        }
        for (int number = 1; number < moment.numbers(); number++) {
            predictor.predictNext(bodies, moment.slot(number), moment.slot(number));
        }
    }

    /** What bodies with mass have given to one without is lost to the world. */
    private void bookMassless(Bodies bodies, int number, double t) {
        int i = moment.slot(number);
        if (bodies.mass(i) == 0 && !bodies.isFixed(i)) {
            double m = 1 / moment.inverseMass(number);
            double ux = moment.pushX(number);
            double uy = moment.pushY(number);
            double work = ux * (paths.vxAt(bodies, i, t) + 0.5 * ux) + uy * (paths.vyAt(bodies, i, t) + 0.5 * uy);
            bodies.ledger().bookEnergy(-m * work);
            bodies.ledger().bookImpulse(-m * ux, -m * uy, bodies.x(i), bodies.y(i));
        }
    }

    private void tell(Bodies bodies, int k, double t, double impulse) {
        if (listener != null) {
            int b = moment.second(k);
            long second = b < 0 ? b : bodies.idValue(b);
            listener.bounced(start + t, bodies.idValue(moment.first(k)), second, moment.closingSpeed(k), impulse);
        }
    }

    /** Books what of the impulse of a contact leaves the world. */
    private void pass(Bodies bodies, int k, double t, double impulse) {
        int a = moment.first(k);
        int b = moment.second(k);
        double nx = moment.normalX(k);
        double ny = moment.normalY(k);
        bodies.ledger().bookEnergy(-impulse * speedByThrust(bodies, a, b, nx, ny, t));
        bookOutside(bodies, a, b, impulse * nx, impulse * ny, paths.dt() - t);
    }

    /**
     * The separating speed that thrust has added by now: it books its own work by kicks at the two ends of the tick, so what it
     * has added or not yet added is none of the bounce's.
     */
    private double speedByThrust(Bodies bodies, int a, int b, double nx, double ny, double t) {
        double x = -bodies.thrustAccelerationX(a);
        double y = -bodies.thrustAccelerationY(a);
        if (b >= 0) {
            x += bodies.thrustAccelerationX(b);
            y += bodies.thrustAccelerationY(b);
        }
        return (x * nx + y * ny) * (t - 0.5 * paths.dt());
    }

    private void bend(Bodies bodies, int i, double t, double dvx, double dvy) {
        if (!bodies.isFixed(i)) {
            paths.bend(bodies, i, t, dvx, dvy);
            predictor.update(bodies, i);
        }
    }

    /**
     * An impulse on a wall or on a fixed body leaves the world. It acts where the free partner stood so long ago at its present
     * velocity: from there on it has moved by what the impulse gives it.
     */
    static void bookOutside(Bodies bodies, int a, int b, double px, double py, double ago) {
        if (b < 0 || bodies.isFixed(b)) {
            bookImpulse(bodies, a, -px, -py, ago);
        } else if (bodies.isFixed(a)) {
            bookImpulse(bodies, b, px, py, ago);
        }
    }

    private static void bookImpulse(Bodies bodies, int i, double px, double py, double ago) {
        double x = bodies.x(i) - ago * bodies.vx(i);
        double y = bodies.y(i) - ago * bodies.vy(i);
        bodies.ledger().bookImpulse(px, py, x, y);
    }
}

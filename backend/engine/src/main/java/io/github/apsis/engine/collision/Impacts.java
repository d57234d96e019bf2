package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import org.jspecify.annotations.Nullable;

/**
 * The bounces of a tick, each at its true time and with its true normal, in the order of their times.
 *
 * <p>An impulse j = (1+e) c / (1/m1 + 1/m2) along the line of centres turns the closing speed c into e c. Both paths bend
 * there, so both bodies look for their next partner from there on. A contact whose closing speed is no more than what the
 * forces give in two ticks is no bounce but a contact at rest, and left to {@link RestingContacts}.
 */
final class Impacts {
    /**
     * A body that is hit more often in one tick is in a collapse (e &lt; 1: infinitely many bounces in finite time) or a
     * bullet in a box. From then on its contacts of this tick are inelastic, and after as many again they are at rest.
     */
    private static final int MOST_BOUNCES_PER_BODY = 64;

    private final double restitution;
    private final double wallRestitution;
    private final Paths paths;
    private final Approach approach;
    private final ImpactQueue queue = new ImpactQueue();
    private final ImpactPredictor predictor;
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
            Touching touching) {
        this.restitution = restitution;
        this.wallRestitution = wallRestitution;
        this.paths = paths;
        this.approach = approach;
        this.predictor = new ImpactPredictor(
                broadPhase, walls, period, paths, approach, queue, touching, 2 * MOST_BOUNCES_PER_BODY);
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
            double t = queue.time();
            int a = queue.first();
            int b = queue.second();
            boolean current = queue.firstVersion() == paths.impacts(a) && queue.secondVersion() == paths.impacts(b);
            queue.pop();
            if (current) { // otherwise it was predicted anew when the path was bent
                bounce(bodies, a, b, t);
            }
        }
    }

    private void bounce(Bodies bodies, int a, int b, double t) {
        approach.measure(bodies, a, b, t);
        ContactGeometry contact = approach.contact();
        boolean collapsed = paths.mostImpacts(a, b) >= MOST_BOUNCES_PER_BODY;
        double e = collapsed ? 0 : b < 0 ? wallRestitution : restitution;
        double impulse = (1 + e) * approach.closingSpeed() / contact.inverseMass;
        if (listener != null) {
            long second = b < 0 ? b : bodies.idValue(b);
            listener.bounced(start + t, bodies.idValue(a), second, approach.closingSpeed(), impulse);
        }
        bookWork(bodies, a, b, t, impulse);
        double px = impulse * contact.nx;
        double py = impulse * contact.ny;
        bookOutside(bodies, a, b, px, py, paths.dt() - t);
        bend(bodies, a, t, -px, -py);
        if (b >= 0) {
            bend(bodies, b, t, px, py);
        }
        predictor.predictNext(bodies, a, b);
        if (b >= 0) {
            predictor.predictNext(bodies, b, a);
            predictor.predict(bodies, a, b);
        }
    }

    private void bend(Bodies bodies, int i, double t, double px, double py) {
        if (bodies.isFixed(i)) {
            return;
        }
        paths.bend(bodies, i, t, px * bodies.inverseMass(i), py * bodies.inverseMass(i));
        predictor.update(bodies, i);
    }

    /**
     * Books what a bounce takes, −(1 − e²) c² / (2 (1/m1 + 1/m2)). Thrust books its own work by kicks at the two ends of the
     * tick, so the speed that it has added or not yet added by now is none of the bounce's.
     */
    private void bookWork(Bodies bodies, int a, int b, double t, double impulse) {
        ContactGeometry contact = approach.contact();
        double thrustX = -bodies.thrustX(a) * bodies.inverseMass(a);
        double thrustY = -bodies.thrustY(a) * bodies.inverseMass(a);
        if (b >= 0) {
            thrustX += bodies.thrustX(b) * bodies.inverseMass(b);
            thrustY += bodies.thrustY(b) * bodies.inverseMass(b);
        }
        double byThrust = (thrustX * contact.nx + thrustY * contact.ny) * (t - 0.5 * paths.dt());
        bodies.ledger()
                .bookEnergy(impulse * (0.5 * impulse * contact.inverseMass - approach.closingSpeed() - byThrust));
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

package io.github.apsis.engine.stepping;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.engine.collision.ContactListener;
import io.github.apsis.engine.collision.ContactSet;
import io.github.apsis.engine.collision.WallSet;
import io.github.apsis.engine.integration.TaylorStep;
import io.github.apsis.engine.integration.ThrustWork;

/**
 * From true contact to true contact: a step of the Taylor series ends where it has lost its accuracy or at the first contact on
 * it, whichever comes first. There bodies bounce, and the next step begins with what that has left of their velocities.
 *
 * <p>Contacts at rest are no events: they are held through what is left of the tick, see {@link HeldContacts}. A tick that needs
 * more than {@value #MOST_STEPS} steps is not finished: the time that is left of it is lost and counted.
 */
public final class EventStepper implements Stepper {
    private static final int MOST_STEPS = 50_000; // of one tick

    private final TaylorStep step;
    private final FirstContact firstContact;
    private final HeldContacts held;
    private final Bounces bounces;
    private final ThrustWork thrust = new ThrustWork();
    private final double dt;

    private long revision = -1;
    private boolean isCurrent; // whether the step leads on from the present state
    private double elapsed; // from the moment of the step to the present
    private double elapsedLow;
    private double nextContact; // from the moment of the step on
    private double hopEnd = Double.POSITIVE_INFINITY; // likewise
    private double lostTime;

    /**
     * @param restitution between bodies
     * @param boundary whose walls, if it has any, are hit as well
     */
    public EventStepper(TaylorStep step, double restitution, Boundary boundary, double dt) {
        this.step = step;
        this.dt = dt;
        var walls = WallSet.of(boundary);
        var pressing = new Pressing(step, dt);
        this.firstContact = new FirstContact(walls, step.newPath());
        this.held = new HeldContacts(new ContactSet(walls), pressing, dt);
        this.bounces = new Bounces(
                new ContactSet(walls), held, pressing, walls, restitution, Boundary.wallRestitution(boundary));
    }

    @Override
    public void onBounce(ContactListener listener) {
        bounces.onBounce(listener);
    }

    @Override
    public void step(Bodies bodies, double time) {
        begin(bodies);
        double target = elapsed + dt;
        double targetLow = elapsedLow + ((elapsed - target) + dt);
        int steps = 0;
        while (target > nextStop()) {
            double until = nextStop();
            step.place(bodies, until, 0);
            double left = target - until;
            targetLow += (target - left) - until;
            target = left;
            if (steps++ == MOST_STEPS) {
                lostTime += left;
                target = 0;
                targetLow = 0;
                beginStep(bodies);
                break;
            }
            stop(bodies, until, time + (dt - left), left);
            beginStep(bodies);
        }
        step.place(bodies, target, targetLow);
        elapsed = target;
        elapsedLow = targetLow;
        end(bodies);
    }

    private double nextStop() {
        return Math.min(Math.min(nextContact, hopEnd), step.length());
    }

    /** Does what is due at a time t of the step, with so much left of the tick. */
    private void stop(Bodies bodies, double t, double time, double left) {
        hopEnd -= t;
        if (hopEnd <= 0) {
            held.settle(bodies, t);
            held.part(bodies, firstContact.overlapping(), t, t);
            held.hold(bodies, t, left);
            hopEnd = hopEnd(left);
        }
        if (t == nextContact && bounces.resolve(bodies, t, time, left)) {
            hopEnd = hopEnd(left);
        }
    }

    /** Hops that last through the tick end with it. */
    private double hopEnd(double left) {
        return held.duration() < left ? held.duration() : Double.POSITIVE_INFINITY;
    }

    private void begin(Bodies bodies) {
        bounces.beginTick(bodies);
        held.beginTick(bodies);
        boolean ships = bodies.ships().length > 0;
        if (bodies.revision() != revision) {
            held.forget(); // slots may have changed
            isCurrent = false;
        }
        if (ships) {
            thrust.begin(bodies);
        }
        if (ships || revision < 0) {
            step.begin(bodies, dt);
            elapsed = 0;
            elapsedLow = 0;
            isCurrent = false;
        }
        if (held.hold(bodies, elapsed, dt) || !isCurrent) {
            beginStep(bodies);
            elapsed = 0;
            elapsedLow = 0;
        }
        hopEnd = elapsed + hopEnd(dt);
    }

    private void beginStep(Bodies bodies) {
        step.begin(bodies, dt);
        nextContact = firstContact.find(bodies, step, held.contacts());
    }

    private void end(Bodies bodies) {
        if (bodies.ships().length > 0) {
            thrust.book(bodies);
        }
        boolean settled = held.settle(bodies, elapsed);
        boolean parted = held.part(bodies, firstContact.overlapping(), elapsed, Math.min(elapsed, dt));
        isCurrent = !settled && !parted;
        bodies.keepFinite();
        revision = bodies.revision();
    }

    @Override
    public boolean needsNumbers() {
        return true;
    }

    @Override
    public double lostTime() {
        return lostTime;
    }

    @Override
    public long pointBounces() {
        return step.bounces();
    }
}

package io.github.apsis.engine.stepping;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.collision.ContactSet;
import java.util.Arrays;

/**
 * Contacts at rest. For what is left of a tick they are no events but small hops: a separating speed that the forces have used up
 * when the tick ends,
 *
 * <pre>
 *   w = a τ / 2 − g / τ
 * </pre>
 *
 * <p>with a the acceleration that presses, g the gap and τ the time that is left. There {@link #settle} takes off what closes.
 * That is RATTLE (Andersen 1983, J. Comput. Phys. 52, 24) with contacts that push and never pull: of second order in the tick, and
 * since it aims at g = 0 from wherever g is, nothing creeps.
 *
 * <p>Partners that overlap are parted along the normal without velocity, in a tick at most a hundredth of the sum of their radii and
 * never faster than ten mean radii per time; what that lifts is booked.
 */
final class HeldContacts {
    /** Beyond this gap, in units of their size, partners have parted. */
    private static final double LOOSE = 1e-6;

    /** An overlap below this share of their size is left alone. */
    private static final double SLOP = 1e-9;

    private static final double LARGEST_PUSH = 0.01; // of the sum of their radii
    private static final double PARTING_SPEED = 5; // sums of radii per time

    /** A hop is shorter than the tick where it would rise by more than this share of the distance of the centres. */
    private static final double HIGHEST = 1e-3;

    private final ContactSet contacts;
    private final Pressing pressing;
    private final double dt;
    private double duration = Double.POSITIVE_INFINITY; // of the hops under way
    private double[] unrest = new double[0]; // of each body: the speed that holding has given it at once in this tick

    HeldContacts(ContactSet contacts, Pressing pressing, double dt) {
        this.contacts = contacts;
        this.pressing = pressing;
        this.dt = dt;
    }

    void beginTick(Bodies bodies) {
        if (unrest.length < bodies.count()) {
            unrest = new double[2 * bodies.count()];
        }
        Arrays.fill(unrest, 0, bodies.count(), 0);
    }

    /**
     * The speed of partners against each other that is nothing but the hops of what holds them: what lies in a pile does not bounce
     * with it.
     */
    double unrest(int a, int b) {
        return b < 0 ? unrest[a] : unrest[a] + unrest[b];
    }

    ContactSet contacts() {
        return contacts;
    }

    /** Returns false when it is held already. */
    boolean add(int a, int b) {
        if (contacts.contains(a, b)) {
            return false;
        }
        contacts.add(a, b);
        return true;
    }

    void forget() {
        contacts.clear();
    }

    /**
     * Lets go of those whose bodies have been struck so hard that they close faster than forces push in a tick. Weaker ones stay at
     * rest: otherwise every bounce in a pile would have all of it bounce.
     *
     * @return whether any has been struck at all
     */
    boolean release(Bodies bodies, boolean[] struck, double t, double left) {
        boolean any = false;
        contacts.measure(bodies);
        for (int k = contacts.size() - 1; k >= 0; k--) {
            int b = contacts.second(k);
            if (struck[contacts.first(k)] || b >= 0 && struck[b]) {
                double a = pressing.acceleration(bodies, contacts, k, t);
                if (contacts.separatingSpeed(k) < hop(k, a, left) - Math.max(0, a) * dt) {
                    contacts.remove(k);
                }
                any = true;
            }
        }
        return any;
    }

    /** The separating speed with which a gap is closed when the tick ends. */
    private double hop(int k, double a, double left) {
        return 0.5 * a * left - Math.max(0, contacts.gap(k)) / left;
    }

    /**
     * Lets all hop, at a time t of the step, through the time that is left of the tick or the {@link #duration} if that is
     * shorter.
     *
     * @return whether that has changed a velocity
     */
    boolean hold(Bodies bodies, double t, double left) {
        if (contacts.size() == 0 || left <= 0) {
            return false;
        }
        contacts.measure(bodies);
        duration = left;
        for (int k = 0; k < contacts.size(); k++) {
            double a = pressing.acceleration(bodies, contacts, k, t);
            double highest = HIGHEST * contacts.distance(k);
            duration = a * left * left > 8 * highest ? Math.min(duration, Math.sqrt(8 * highest / a)) : duration;
        }
        for (int k = 0; k < contacts.size(); k++) {
            contacts.want(k, hop(k, pressing.acceleration(bodies, contacts, k, t), duration));
        }
        boolean pushed = contacts.push(bodies);
        if (pushed) {
            noteUnrest(bodies);
        }
        return pushed;
    }

    /** How long hops last from when they began; infinite when nothing hops. */
    double duration() {
        return contacts.size() == 0 ? Double.POSITIVE_INFINITY : duration;
    }

    private void noteUnrest(Bodies bodies) {
        for (int k = 0; k < contacts.size(); k++) {
            int a = contacts.first(k);
            int b = contacts.second(k);
            unrest[a] = Math.max(unrest[a], 2 * contacts.impulse(k) * bodies.inverseMass(a));
            if (b >= 0) {
                unrest[b] = Math.max(unrest[b], 2 * contacts.impulse(k) * bodies.inverseMass(b));
            }
        }
    }

    /**
     * Ends the hops, at a time t of the step.
     *
     * @return whether that has changed a velocity or a position
     */
    boolean settle(Bodies bodies, double t) {
        if (contacts.size() == 0) {
            return false;
        }
        contacts.measure(bodies);
        for (int k = 0; k < contacts.size(); k++) {
            contacts.want(k, isLoose(bodies, k) ? Double.NEGATIVE_INFINITY : 0);
        }
        boolean pushed = contacts.push(bodies);
        contacts.measure(bodies);
        for (int k = contacts.size() - 1; k >= 0; k--) {
            double a = pressing.acceleration(bodies, contacts, k, t);
            double gentle =
                    pressing.gentleSpeed(bodies, contacts, k, a, t) + unrest(contacts.first(k), contacts.second(k));
            if (isLoose(bodies, k) || contacts.separatingSpeed(k) > gentle || a < 0) {
                contacts.remove(k);
            }
        }
        return pushed;
    }

    private boolean isLoose(Bodies bodies, int k) {
        return contacts.gap(k) > LOOSE * contacts.size(bodies, k);
    }

    /**
     * Parts what overlaps, at a time t of the step, after so long.
     *
     * @return whether that has changed a position
     */
    boolean part(Bodies bodies, ContactSet overlapping, double t, double lasted) {
        boolean moved = false;
        for (int k = 0; k < overlapping.size(); k++) {
            overlapping.measure(bodies, k);
            if (overlapping.gap(k) < -SLOP * overlapping.size(bodies, k)) {
                part(bodies, overlapping, k, mostPush(bodies, overlapping, k, lasted), t);
                moved = true;
            }
        }
        return moved;
    }

    /** How far a pair may be parted; in a wall a body meets its image, and a centre beyond it comes back at once. */
    private static double mostPush(Bodies bodies, ContactSet overlapping, int k, double lasted) {
        double share = Math.min(LARGEST_PUSH, PARTING_SPEED * lasted);
        double radius = bodies.radius(overlapping.first(k));
        int b = overlapping.second(k);
        return b < 0 ? Math.max(share * 2 * radius, -overlapping.gap(k) - radius) : share * (radius + bodies.radius(b));
    }

    private void part(Bodies bodies, ContactSet overlapping, int k, double most, double t) {
        int a = overlapping.first(k);
        int b = overlapping.second(k);
        double inverseMass = bodies.inverseMass(a) + (b < 0 ? 0 : bodies.inverseMass(b));
        double push = Math.min(-overlapping.gap(k), most) / inverseMass;
        double px = push * overlapping.normalX(k);
        double py = push * overlapping.normalY(k);
        shift(bodies, a, -px * bodies.inverseMass(a), -py * bodies.inverseMass(a), t);
        if (b >= 0) {
            shift(bodies, b, px * bodies.inverseMass(b), py * bodies.inverseMass(b), t);
        }
    }

    private void shift(Bodies bodies, int i, double dx, double dy, double t) {
        if (bodies.isFixed(i)) {
            return;
        }
        bodies.ledger().bookEnergy(-pressing.work(bodies, i, t, dx, dy));
        bodies.ledger().bookAngularMomentum(bodies.mass(i) * (dx * bodies.vy(i) - dy * bodies.vx(i)));
        bodies.shift(i, dx, dy);
    }
}

package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import org.jspecify.annotations.Nullable;

/**
 * Contacts at rest: bodies that lie on each other neither sink nor tremble, and a body that slides over another keeps its
 * energy.
 *
 * <p>The method is RATTLE (Andersen 1983, J. Comput. Phys. 52, 24) with contacts that push and never pull. {@link #hold}
 * changes velocities in the middle of the tick, along the normal of its start, so that no pair ends it deeper in each other
 * than it began; {@link #settle} takes off what still closes at its end. Both run over all contacts in turn with accumulated,
 * clamped impulses (sequential impulses, Catto 2005, GDC, "Iterative dynamics with temporal coherence").
 *
 * <p>An overlap that was there before is parted by direct projection: velocities never learn of it, heavy bodies give way
 * less, the centre of mass stays, and what it lifts against the forces is booked.
 */
final class RestingContacts {
    private static final int MOST_ROUNDS = 200;
    private static final int MOST_PARTING_ROUNDS = 30;

    /** Rounds go on until the largest correction is this share of the first round's largest: far below what shows. */
    private static final double SETTLED = 1e-9;

    /** An overlap below this share of the radii is left alone: chasing rounding would keep a pile trembling. */
    private static final double SLOP = 1e-7;

    /** Bodies born inside each other part by at most this share of their radii per round, not by an explosion. */
    private static final double LARGEST_PUSH = 0.01;

    /** And no body is parted faster than this, in mean radii of its contact per time: a crowd spreads, it does not burst. */
    private static final double PARTING_SPEED = 10;

    private final Touching touching;
    private final ContactGeometry contact;
    private final Extrapolation extrapolation = new Extrapolation();
    private double[] leeway = new double[16]; // how far parting may still move a body in this tick, length

    RestingContacts(Touching touching, @Nullable WallSet walls, @Nullable Period period) {
        this.touching = touching;
        this.contact = new ContactGeometry(walls, period);
    }

    /** Keeps every pair from ending the tick deeper in each other, then parts old overlaps. */
    void hold(Bodies bodies, double dt) {
        if (touching.size() == 0) {
            return;
        }
        extrapolation.begin(bodies, touching);
        double first = holdAll(bodies, 0, dt);
        double largest = first;
        for (int round = 1; round < MOST_ROUNDS && largest > SETTLED * first; round++) {
            if (round % 2 == 0 && extrapolation.proceed(touching)) {
                jumpHolding(bodies, dt);
            }
            largest = holdAll(bodies, round, dt);
        }
        limitParting(bodies, dt);
        boolean overlapping = true;
        for (int round = 0; round < MOST_PARTING_ROUNDS && overlapping; round++) {
            overlapping = partAll(bodies, round);
        }
    }

    /** Takes from every pair that touches the closing speed that the end of the tick has left it. */
    void settle(Bodies bodies) {
        if (touching.size() == 0) {
            return;
        }
        touching.clearImpulses();
        extrapolation.begin(bodies, touching);
        double first = settleAll(bodies, 0);
        double largest = first;
        for (int round = 1; round < MOST_ROUNDS && largest > SETTLED * first; round++) {
            if (round % 2 == 0 && extrapolation.proceed(touching)) {
                jumpSettling(bodies);
            }
            largest = settleAll(bodies, round);
        }
    }

    private void jumpHolding(Bodies bodies, double dt) {
        for (int k = 0; k < touching.size(); k++) {
            holdBy(bodies, k, extra(k), dt);
        }
    }

    private void jumpSettling(Bodies bodies) {
        for (int k = 0; k < touching.size(); k++) {
            contact.fillNow(bodies, touching.first(k), touching.second(k));
            settleBy(bodies, k, extra(k));
        }
    }

    /** The impulse that a jump adds to a contact before its next round. */
    private double extra(int k) {
        double extra = extrapolation.extra(k);
        touching.setImpulse(k, touching.impulse(k) + extra);
        return extra;
    }

    private double holdAll(Bodies bodies, int round, double dt) {
        double largest = 0;
        for (int k = 0; k < touching.size(); k++) {
            largest = Math.max(largest, hold(bodies, inTurn(k, round), dt));
        }
        return largest;
    }

    private double settleAll(Bodies bodies, int round) {
        double largest = 0;
        for (int k = 0; k < touching.size(); k++) {
            largest = Math.max(largest, settle(bodies, inTurn(k, round)));
        }
        return largest;
    }

    private boolean partAll(Bodies bodies, int round) {
        boolean moved = false;
        for (int k = 0; k < touching.size(); k++) {
            int turn = inTurn(k, round);
            moved |= part(bodies, touching.first(turn), touching.second(turn));
        }
        return moved;
    }

    private void limitParting(Bodies bodies, double dt) {
        if (bodies.count() > leeway.length) {
            leeway = new double[Math.max(bodies.count(), 2 * leeway.length)];
        }
        for (int k = 0; k < touching.size(); k++) {
            leeway[touching.first(k)] = 0;
            if (touching.second(k) >= 0) {
                leeway[touching.second(k)] = 0;
            }
        }
        for (int k = 0; k < touching.size(); k++) {
            int a = touching.first(k);
            int b = touching.second(k);
            double radius = b < 0 ? bodies.radius(a) : 0.5 * (bodies.radius(a) + bodies.radius(b));
            double most = PARTING_SPEED * radius * dt;
            leeway[a] = Math.max(leeway[a], most);
            if (b >= 0) {
                leeway[b] = Math.max(leeway[b], most);
            }
        }
    }

    /** Every other round runs backwards: what one end of a stack knows reaches the other in one round. */
    private int inTurn(int k, int round) {
        return round % 2 == 0 ? k : touching.size() - 1 - k;
    }

    private double hold(Bodies bodies, int k, double dt) {
        int a = touching.first(k);
        int b = touching.second(k);
        contact.fillNow(bodies, a, b);
        if (contact.inverseMass == 0) {
            return 0;
        }
        double missing = Math.min(0, touching.firstGap(k)) - contact.gap;
        double impulse = addedImpulse(k, missing / dt);
        holdBy(bodies, k, impulse, dt);
        return Math.abs(impulse) * contact.inverseMass;
    }

    private void holdBy(Bodies bodies, int k, double impulse, double dt) {
        if (impulse == 0) {
            return;
        }
        int a = touching.first(k);
        int b = touching.second(k);
        double px = impulse * touching.normalX(k);
        double py = impulse * touching.normalY(k);
        double halfTick = 0.5 * dt;
        bookWork(bodies, a, b, px, py, halfTick);
        Impacts.bookOutside(bodies, a, b, px, py, dt);
        push(bodies, a, b, px, py);
        lift(bodies, a, -px * dt, -py * dt);
        if (b >= 0) {
            lift(bodies, b, px * dt, py * dt);
        }
    }

    private double settle(Bodies bodies, int k) {
        int a = touching.first(k);
        int b = touching.second(k);
        contact.fillNow(bodies, a, b);
        double size = bodies.radius(a) + (b < 0 ? 0 : bodies.radius(b));
        if (contact.inverseMass == 0 || contact.gap > SLOP * size) {
            return 0;
        }
        double wx = (b < 0 ? 0 : bodies.vx(b)) - bodies.vx(a);
        double wy = (b < 0 ? 0 : bodies.vy(b)) - bodies.vy(a);
        double impulse = addedImpulse(k, -(wx * contact.nx + wy * contact.ny));
        settleBy(bodies, k, impulse);
        return Math.abs(impulse) * contact.inverseMass;
    }

    private void settleBy(Bodies bodies, int k, double impulse) {
        if (impulse == 0) {
            return;
        }
        double px = impulse * contact.nx;
        double py = impulse * contact.ny;
        bookWork(bodies, touching.first(k), touching.second(k), px, py, 0);
        Impacts.bookOutside(bodies, touching.first(k), touching.second(k), px, py, 0);
        push(bodies, touching.first(k), touching.second(k), px, py);
    }

    /** The impulse that adds this separating speed, cut so that the contact's impulses together never pull. */
    private double addedImpulse(int k, double speed) {
        double before = touching.impulse(k);
        double after = Math.max(0, before + speed / contact.inverseMass);
        touching.setImpulse(k, after);
        return after - before;
    }

    /**
     * Books the work p · (w + p/2m) of an impulse on the velocities that the forces will have made of these by the end of the
     * tick; thrust books its own work when it comes.
     */
    private static void bookWork(Bodies bodies, int a, int b, double px, double py, double untilEnd) {
        double wx = -bodies.vx(a) - untilEnd * bodies.ax(a);
        double wy = -bodies.vy(a) - untilEnd * bodies.ay(a);
        double inverseMass = bodies.inverseMass(a);
        if (b >= 0) {
            wx += bodies.vx(b) + untilEnd * bodies.ax(b);
            wy += bodies.vy(b) + untilEnd * bodies.ay(b);
            inverseMass += bodies.inverseMass(b);
        }
        bodies.ledger().bookEnergy(px * wx + py * wy + 0.5 * inverseMass * (px * px + py * py));
    }

    private static void push(Bodies bodies, int a, int b, double px, double py) {
        bodies.push(a, -px * bodies.inverseMass(a), -py * bodies.inverseMass(a));
        if (b >= 0) {
            bodies.push(b, px * bodies.inverseMass(b), py * bodies.inverseMass(b));
        }
    }

    private boolean part(Bodies bodies, int a, int b) {
        contact.fillNow(bodies, a, b);
        double size = bodies.radius(a) + (b < 0 ? 0 : bodies.radius(b));
        if (contact.gap >= -SLOP * size || contact.inverseMass == 0) {
            return false;
        }
        double push = Math.min(-contact.gap, LARGEST_PUSH * size) / contact.inverseMass;
        push = withinLeeway(bodies, a, push);
        if (b >= 0) {
            push = withinLeeway(bodies, b, push);
        }
        if (push == 0) {
            return false;
        }
        partBy(bodies, a, -push, contact.nx, contact.ny);
        if (b >= 0) {
            partBy(bodies, b, push, contact.nx, contact.ny);
        }
        return true;
    }

    /** Cuts a push, mass · length, to what this body may still move. */
    private double withinLeeway(Bodies bodies, int i, double push) {
        return bodies.isFixed(i) ? push : Math.min(push, leeway[i] / bodies.inverseMass(i));
    }

    private void partBy(Bodies bodies, int i, double push, double nx, double ny) {
        leeway[i] = Math.max(0, leeway[i] - Math.abs(push) * bodies.inverseMass(i));
        bodies.ledger().bookAngularMomentum(bodies.isFixed(i) ? 0 : push * (nx * bodies.vy(i) - ny * bodies.vx(i)));
        lift(bodies, i, push * nx, push * ny);
    }

    /** Moves a free body by {@code (mx, my) / m}, and books what that lifts it against the forces. */
    private static void lift(Bodies bodies, int i, double mx, double my) {
        if (!bodies.isFixed(i)) {
            bodies.ledger().bookEnergy(-(mx * bodies.ax(i) + my * bodies.ay(i)));
            bodies.shift(i, mx * bodies.inverseMass(i), my * bodies.inverseMass(i));
        }
    }
}

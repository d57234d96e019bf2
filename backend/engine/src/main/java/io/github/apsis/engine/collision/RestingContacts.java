package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import org.jspecify.annotations.Nullable;

/**
 * Contacts at rest: bodies that lie on each other neither sink nor tremble.
 *
 * <p>Velocities by sequential impulses with accumulated clamping (Catto 2005, GDC, "Iterative dynamics with temporal
 * coherence"): no pair may end the tick closing faster than the gap between them allows, and no contact may pull. Positions
 * afterwards by direct projection, heavy bodies giving way less, so that the centre of mass stays; velocities never learn of
 * it, and what it lifts against the forces is booked.
 */
final class RestingContacts {
    private static final int MOST_VELOCITY_ROUNDS = 200;
    private static final int MOST_POSITION_ROUNDS = 30;

    /** Rounds go on until the largest correction is this share of the first round's largest: far below what shows. */
    private static final double SETTLED = 1e-9;

    /** An overlap below this share of the radii is left alone: chasing rounding would keep a pile trembling. */
    private static final double SLOP = 1e-7;

    /** Bodies born inside each other part by at most this share of their radii per round, not by an explosion. */
    private static final double LARGEST_PUSH = 0.01;

    private final Touching touching;
    private final ContactGeometry contact;

    RestingContacts(Touching touching, @Nullable WallSet walls, @Nullable Period period) {
        this.touching = touching;
        this.contact = new ContactGeometry(walls, period);
    }

    void resolve(Bodies bodies, double dt) {
        if (touching.size() == 0) {
            return;
        }
        double first = stopAll(bodies, 0, dt);
        double largest = first;
        for (int round = 1; round < MOST_VELOCITY_ROUNDS && largest > SETTLED * first; round++) {
            largest = stopAll(bodies, round, dt);
        }
        boolean overlapping = true;
        for (int round = 0; round < MOST_POSITION_ROUNDS && overlapping; round++) {
            overlapping = partAll(bodies, round);
        }
    }

    private double stopAll(Bodies bodies, int round, double dt) {
        double largest = 0;
        for (int k = 0; k < touching.size(); k++) {
            largest = Math.max(largest, stop(bodies, inTurn(k, round), dt));
        }
        return largest;
    }

    /** Every other round runs backwards: what one end of a stack knows reaches the other in one round. */
    private int inTurn(int k, int round) {
        return round % 2 == 0 ? k : touching.size() - 1 - k;
    }

    /** Takes from one contact the closing speed it may not have; returns the change. */
    private double stop(Bodies bodies, int k, double dt) {
        int a = touching.first(k);
        int b = touching.second(k);
        contact.fillNow(bodies, a, b);
        if (contact.inverseMass == 0) {
            return 0;
        }
        double wx = (b < 0 ? 0 : bodies.vx(b)) - bodies.vx(a);
        double wy = (b < 0 ? 0 : bodies.vy(b)) - bodies.vy(a);
        // Velocities are those of the middle of the tick; half of the forces' push is still to come.
        double separating = wx * contact.nx + wy * contact.ny + 0.5 * dt * contact.separatingAcceleration(bodies, a, b);
        double allowed = -Math.max(0, contact.gap) / dt;
        double before = touching.impulse(k);
        double after = Math.max(0, before + (allowed - separating) / contact.inverseMass);
        double impulse = after - before;
        if (impulse == 0) {
            return 0;
        }
        touching.setImpulse(k, after);
        bodies.ledger().bookEnergy(impulse * (separating + 0.5 * impulse * contact.inverseMass));
        double px = impulse * contact.nx;
        double py = impulse * contact.ny;
        bodies.push(a, -px * bodies.inverseMass(a), -py * bodies.inverseMass(a));
        if (b >= 0) {
            bodies.push(b, px * bodies.inverseMass(b), py * bodies.inverseMass(b));
        }
        Impacts.bookOutside(bodies, a, b, px, py);
        return Math.abs(impulse) * contact.inverseMass;
    }

    private boolean partAll(Bodies bodies, int round) {
        boolean moved = false;
        for (int k = 0; k < touching.size(); k++) {
            int turn = inTurn(k, round);
            moved |= part(bodies, touching.first(turn), touching.second(turn));
        }
        return moved;
    }

    private boolean part(Bodies bodies, int a, int b) {
        contact.fillNow(bodies, a, b);
        double size = bodies.radius(a) + (b < 0 ? 0 : bodies.radius(b));
        if (contact.gap >= -SLOP * size || contact.inverseMass == 0) {
            return false;
        }
        double push = Math.min(-contact.gap, LARGEST_PUSH * size) / contact.inverseMass;
        lift(bodies, a, -push * contact.nx, -push * contact.ny);
        if (b >= 0) {
            lift(bodies, b, push * contact.nx, push * contact.ny);
        }
        return true;
    }

    /** Moves a body by {@code (mx, my) / m}, and books what that lifts it against the forces. */
    private static void lift(Bodies bodies, int i, double mx, double my) {
        bodies.ledger().bookEnergy(-(mx * bodies.ax(i) + my * bodies.ay(i)) * (bodies.isFixed(i) ? 0 : 1));
        bodies.shift(i, mx * bodies.inverseMass(i), my * bodies.inverseMass(i));
    }
}

package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;

/**
 * Takes overlaps that were there before apart by moving bodies, a share of each in every tick: velocities never learn of it,
 * heavy bodies give way less, the centre of mass stays, and what it lifts against the forces is booked.
 *
 * <p>All pairs are parted at once, by the least displacements (weighed by mass) that push no other pair together: pair after
 * pair, each parting would press its neighbours into each other, and a pile would tremble for ever.
 */
final class Parting {
    /** An overlap below this share of the radii is rounding. */
    private static final double SLOP = 1e-7;

    /**
     * Under forces so much more is left alone, or what they move a body in a tick, if that is less: a large heap finds its
     * impulses over several ticks, and parting what it has not found yet would keep it trembling.
     */
    private static final double ALLOWED = 5e-4;

    /** Of an overlap in one tick. */
    private static final double SHARE = 0.2;

    /** No body is parted faster than so many of its radii per time: a crowd spreads, it does not burst. */
    private static final double FASTEST = 10;

    private static final double TOLERANCE = 1e-6; // of the largest displacement; the next tick parts what is left

    private final Touching touching;
    private final ContactGeometry contact;
    private final ImpulseSolver solver = new ImpulseSolver();

    Parting(Touching touching, ContactGeometry contact) {
        this.touching = touching;
        this.contact = contact;
    }

    /** Parts all pairs as far as a tick allows. */
    void part(Bodies bodies, double dt, int mostRounds) {
        if (!overlapping(bodies, dt)) {
            touching.clearParting();
            return;
        }
        solver.begin(touching.size(), bodies.count());
        for (int k = 0; k < touching.size(); k++) {
            int a = touching.first(k);
            int b = touching.second(k);
            contact.fillNow(bodies, a, b);
            double secondInverseMass = b < 0 ? 0 : bodies.inverseMass(b);
            solver.add(a, b, contact.nx, contact.ny, bodies.inverseMass(a), secondInverseMass, touching.parting(k));
            solver.measured(
                    k, contact.gap < -allowed(bodies, a, b, dt) ? SHARE * contact.gap : Math.max(0, contact.gap));
        }
        solver.solveFrom(TOLERANCE, mostRounds);
        for (int k = 0; k < touching.size(); k++) {
            touching.setParting(k, solver.impulse(k));
        }
        solver.push();
        move(bodies, share(bodies, dt));
    }

    private boolean overlapping(Bodies bodies, double dt) {
        for (int k = 0; k < touching.size(); k++) {
            int a = touching.first(k);
            int b = touching.second(k);
            contact.fillNow(bodies, a, b);
            if (contact.gap < -allowed(bodies, a, b, dt)) {
                return true;
            }
        }
        return false;
    }

    private static double allowed(Bodies bodies, int a, int b, double dt) {
        double size = bodies.radius(a) + (b < 0 ? 0 : bodies.radius(b));
        return SLOP * size + Math.min(ALLOWED * size, Paths.acceleration(bodies, a, b) * dt * dt);
    }

    /** The share of all displacements at which nobody moves too fast. */
    private double share(Bodies bodies, double dt) {
        double share = 1;
        for (int i = 0; i < bodies.count(); i++) {
            double moved = Math.sqrt(solver.pushX(i) * solver.pushX(i) + solver.pushY(i) * solver.pushY(i));
            double most = FASTEST * bodies.radius(i) * dt;
            if (moved > most) {
                share = Math.min(share, most / moved);
            }
        }
        return share;
    }

    private void move(Bodies bodies, double share) {
        double energy = 0;
        double moment = 0;
        for (int i = 0; i < bodies.count(); i++) {
            double ux = share * solver.pushX(i);
            double uy = share * solver.pushY(i);
            if (ux != 0 || uy != 0) {
                energy -= bodies.mass(i) * (ux * bodies.ax(i) + uy * bodies.ay(i));
                moment += bodies.mass(i) * (ux * bodies.vy(i) - uy * bodies.vx(i));
                bodies.shift(i, ux, uy);
            }
        }
        bodies.ledger().bookEnergy(energy);
        bodies.ledger().bookAngularMomentum(moment);
    }
}

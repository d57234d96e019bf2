package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;

/** Passes the impulses of contacts at rest on to the bodies, and books what leaves the world. */
final class ContactPushes {
    private final ImpulseSolver solver;
    private double work; // of all impulses that hold, on the mean velocities of the tick
    private double workThere; // the same without signs

    ContactPushes(ImpulseSolver solver) {
        this.solver = solver;
    }

    /** Forgets the work that was done. */
    void begin() {
        work = 0;
        workThere = 0;
    }

    /** Whether impulses in the middle of the tick did more work than such a share of it, which is rounding. */
    boolean didWork(double share) {
        return work > share * workThere;
    }

    /** Impulses in the middle of the tick: velocities change, and the path from its start on. */
    void pushHolding(Bodies bodies, double dt) {
        bookOutside(bodies, dt);
        solver.push();
        double energy = 0;
        for (int number = 1; number < solver.numbers(); number++) {
            int i = solver.slot(number);
            double ux = solver.pushX(number);
            double uy = solver.pushY(number);
            if (ux != 0 || uy != 0) {
                double along = ux * bodies.vx(i) + uy * bodies.vy(i);
                double across = 0.5 * (ux * ux + uy * uy);
                work += bodies.mass(i) * (along + across);
                workThere += bodies.mass(i) * (Math.abs(along) + across);
                // Of the velocity that the forces will have made by the end, and against them along the way.
                energy += bodies.mass(i) * work(bodies, i, ux, uy, 0.5 * dt);
                energy -= bodies.mass(i) * dt * (ux * bodies.ax(i) + uy * bodies.ay(i));
                bookMassless(bodies, number, ux, uy);
                bodies.push(i, ux, uy);
                bodies.shift(i, ux * dt, uy * dt);
            }
        }
        bodies.ledger().bookEnergy(energy);
    }

    /** Impulses at the end of the tick. */
    void pushSettling(Bodies bodies) {
        bookOutside(bodies, 0);
        solver.push();
        double energy = 0;
        for (int number = 1; number < solver.numbers(); number++) {
            int i = solver.slot(number);
            double ux = solver.pushX(number);
            double uy = solver.pushY(number);
            if (ux != 0 || uy != 0) {
                energy += bodies.mass(i) * work(bodies, i, ux, uy, 0);
                bookMassless(bodies, number, ux, uy);
                bodies.push(i, ux, uy);
            }
        }
        bodies.ledger().bookEnergy(energy);
    }

    /** What bodies with mass have given to one without is lost to the world. */
    private void bookMassless(Bodies bodies, int number, double ux, double uy) {
        int i = solver.slot(number);
        if (bodies.mass(i) == 0) {
            double m = 1 / solver.inverseMass(number);
            bodies.ledger().bookImpulse(-m * ux, -m * uy, bodies.x(i), bodies.y(i));
        }
    }

    /** The work u · (v + u/2) per mass on the velocity that the forces will have made; thrust books its own when it comes. */
    private static double work(Bodies bodies, int i, double ux, double uy, double untilEnd) {
        double vx = bodies.vx(i) + untilEnd * bodies.ax(i);
        double vy = bodies.vy(i) + untilEnd * bodies.ay(i);
        return ux * (vx + 0.5 * ux) + uy * (vy + 0.5 * uy);
    }

    private void bookOutside(Bodies bodies, double ago) {
        for (int s = 0; s < solver.size(); s++) {
            int a = solver.first(s);
            int b = solver.second(s);
            if (b < 0 || bodies.isFixed(a) || bodies.isFixed(b)) {
                Impacts.bookOutside(bodies, a, b, solver.unpushedX(s), solver.unpushedY(s), ago);
            }
        }
    }
}

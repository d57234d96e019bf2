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
     * Under forces so much more is left alone, or what they move a body in a tick, if that is less: the impulses of a heap are
     * not all found in one tick, and to part what that leaves would keep it trembling.
     */
    private static final double ALLOWED = 5e-4;

    /** In a heap of so many contacts and more it takes many ticks, and still more is left alone. */
    private static final int LARGE = 2000;

    private static final double ALLOWED_IN_LARGE = 1e-2;

    /** What is deeper by less than this share of that is not worth its rounds there: a fifth of it in every tick would never end. */
    private static final double HARDLY = 1e-3;

    /** Less than this share of the radii is not worth a factor. */
    private static final double WORTH = 1e-6;

    /** Displacements of a tick are of the size of what contacts miss. */
    private static final double STIFFNESS = 1e3;

    /** Of an overlap in one tick. */
    private static final double SHARE = 0.2;

    /** No body is parted faster than this, in mean radii of its largest contact per time: a crowd spreads, it does not burst. */
    private static final double FASTEST = 10;

    private static final double TOLERANCE = 1e-6; // of the largest displacement; the next tick parts what is left

    private final Touching touching;
    private final ContactGeometry contact;
    private final ImpulseSolver solver = new ImpulseSolver();
    private final HeapSolver heap = new HeapSolver(STIFFNESS);
    private double allowed; // in this tick, as a share of the radii

    Parting(Touching touching, ContactGeometry contact) {
        this.touching = touching;
        this.contact = contact;
    }

    /** Parts all pairs as far as a tick allows; a quiet heap stays so when nobody is pressed. */
    void part(Bodies bodies, double dt, int mostRounds, boolean isQuiet) {
        allowed = touching.size() < LARGE ? ALLOWED : ALLOWED_IN_LARGE;
        double worst = worst(bodies, dt);
        if (worst == 0) {
            touching.clearParting();
            return;
        }
        solver.begin(touching.size(), bodies);
        for (int k = 0; k < touching.size(); k++) {
            int a = touching.first(k);
            int b = touching.second(k);
            contact.fillNow(bodies, a, b);
            solver.add(a, b, contact.nx, contact.ny, touching.parting(k));
            double beyond = contact.gap + allowed(bodies, a, b, dt);
            solver.measured(k, beyond < 0 ? SHARE * beyond : Math.max(0, contact.gap));
        }
        if (isQuiet && worst > WORTH) {
            solver.solveFromDirectly(heap, bodies, TOLERANCE, mostRounds);
        } else {
            solver.solveFrom(TOLERANCE, mostRounds);
        }
        for (int k = 0; k < touching.size(); k++) {
            touching.setParting(k, solver.impulse(k));
        }
        solver.push();
        move(bodies, share(bodies, dt));
    }

    /** Parts the next heap as if it were the first. */
    void forgetHeap() {
        heap.forget();
    }

    /** The most by which a pair lies deeper than allowed, as a share of its radii. */
    private double worst(Bodies bodies, double dt) {
        double hardly = touching.size() < LARGE ? 0 : HARDLY;
        double worst = 0;
        for (int k = 0; k < touching.size(); k++) {
            int a = touching.first(k);
            int b = touching.second(k);
            double gap = contact.gapNow(bodies, a, b);
            double size = bodies.radius(a) + (b < 0 ? 0 : bodies.radius(b));
            if (-gap > SLOP * size) { // or it lies no deeper than is allowed anyway
                double most = allowed(bodies, a, b, dt);
                double beyond = -gap - most;
                worst = beyond > hardly * most ? Math.max(worst, beyond / size) : worst;
            }
        }
        return worst;
    }

    private double allowed(Bodies bodies, int a, int b, double dt) {
        double size = bodies.radius(a) + (b < 0 ? 0 : bodies.radius(b));
        double pressed = Math.min(1, Paths.acceleration(bodies, a, b) * dt * dt / (ALLOWED * size));
        return (SLOP + pressed * allowed) * size;
    }

    /** The share of all displacements at which nobody moves too fast. */
    private double share(Bodies bodies, double dt) {
        double share = 1;
        for (int k = 0; k < touching.size(); k++) {
            int a = touching.first(k);
            int b = touching.second(k);
            double radius = b < 0 ? bodies.radius(a) : 0.5 * (bodies.radius(a) + bodies.radius(b));
            double most = FASTEST * radius * dt;
            share = Math.min(share, most / Math.max(most, moved(solver.firstNumber(k))));
            share = b < 0 ? share : Math.min(share, most / Math.max(most, moved(solver.secondNumber(k))));
        }
        return share;
    }

    private double moved(int number) {
        double x = solver.pushX(number);
        double y = solver.pushY(number);
        return Math.sqrt(x * x + y * y);
    }

    private void move(Bodies bodies, double share) {
        double energy = 0;
        double moment = 0;
        for (int number = 1; number < solver.numbers(); number++) {
            int i = solver.slot(number);
            double ux = share * solver.pushX(number);
            double uy = share * solver.pushY(number);
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

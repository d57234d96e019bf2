package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.spatial.Workspace;

/**
 * What lies still. Impulses are right to some digits, nine in a large heap; it creeps by what they miss, its contacts change by that, and
 * every tick would look for other impulses. So a heap that lies on a wall or on a fixed body stays where it is, to the bit, while none
 * of its bodies is faster than
 *
 * <pre>
 *   |v| ≤ ε |a| dt
 * </pre>
 *
 * <p>with a the acceleration without contacts and ε a share that {@link RestingContacts#creep} tells. That is a static friction of ε, and
 * it holds heaps as a whole: whoever is pushed by more moves, and with him all that he touches. The next tick starts where this one did:
 * see {@link LyingHeaps}.
 */
final class Standstill {
    // What is true of one of a heap is true of it.
    private static final int MOVES = 1;
    private static final int BORNE = 2;

    private final Paths paths;
    private final Touching touching;
    private final HeldBodies held;
    private final LyingHeaps lying;
    private final Workspace workspace;
    private int[] heap = new int[0]; // of each body: another of its heap, itself for the first
    private int[] state = new int[0]; // of the first of each heap

    Standstill(Paths paths, Touching touching, HeldBodies held, LyingHeaps lying, Workspace workspace) {
        this.paths = paths;
        this.touching = touching;
        this.held = held;
        this.lying = lying;
        this.workspace = workspace;
    }

    /**
     * Puts back what has hardly moved in this tick, and books it to what bears it.
     *
     * @param creep ε
     * @param drawn whether held bodies were noted where their paths were drawn to
     */
    void stop(Bodies bodies, double creep, boolean drawn) {
        workspace.take(this);
        heap = workspace.ints(0, bodies.count());
        state = workspace.ints(1, bodies.count());
        boolean anySlow = false;
        for (int i = held.next(0); i >= 0; i = held.next(i + 1)) {
            heap[i] = i;
            state[i] = isSlow(bodies, i, creep) ? 0 : MOVES;
            anySlow |= state[i] == 0;
        }
        if (anySlow) {
            for (int k = 0; k < touching.size(); k++) {
                join(bodies, touching.first(k), touching.second(k));
            }
            for (int i = held.next(0); i >= 0; i = held.next(i + 1)) {
                if (isStill(i)) {
                    stop(bodies, i);
                }
            }
            if (drawn) {
                noteLying(bodies);
            }
        }
    }

    private boolean isStill(int i) {
        return state[first(i)] == BORNE;
    }

    private void noteLying(Bodies bodies) {
        for (int k = 0; k < touching.size(); k++) {
            int a = touching.first(k);
            int b = touching.second(k);
            if (isStill(a) || b >= 0 && isStill(b)) {
                lying.noteContact(k);
            }
        }
        int k = 0;
        for (int i = held.next(0); i >= 0; i = held.next(i + 1), k++) {
            if (isStill(i) || bodies.isFixed(i)) {
                lying.note(i, held.x(k), held.y(k));
            }
        }
    }

    private void join(Bodies bodies, int a, int b) {
        if (b < 0 || bodies.isFixed(b)) {
            state[first(a)] |= BORNE;
        } else if (bodies.isFixed(a)) {
            state[first(b)] |= BORNE;
        } else {
            int one = first(a);
            int other = first(b);
            heap[other] = one;
            state[one] |= state[other];
        }
    }

    private int first(int i) {
        int first = i;
        while (heap[first] != first) {
            heap[first] = heap[heap[first]];
            first = heap[first];
        }
        return first;
    }

    private boolean isSlow(Bodies bodies, int i, double creep) {
        double dt = paths.dt();
        double ax = Paths.accelerationX(bodies, i);
        double ay = Paths.accelerationY(bodies, i);
        double most = creep * creep * dt * dt * (ax * ax + ay * ay);
        double dx = bodies.x(i) - paths.startX(i);
        double dy = bodies.y(i) - paths.startY(i);
        return bodies.vx(i) * bodies.vx(i) + bodies.vy(i) * bodies.vy(i) <= most
                && dx * dx + dy * dy <= dt * dt * most
                && paths.impacts(i) == 0;
    }

    private void stop(Bodies bodies, int i) {
        double m = bodies.mass(i);
        double vx = bodies.vx(i);
        double vy = bodies.vy(i);
        double dx = bodies.x(i) - paths.startX(i) + bodies.xLow(i);
        double dy = bodies.y(i) - paths.startY(i) + bodies.yLow(i);
        double lift = dx * bodies.ax(i) + dy * bodies.ay(i);
        bodies.ledger().bookEnergy(m * (lift - 0.5 * (vx * vx + vy * vy)));
        bodies.ledger().bookImpulse(-m * vx, -m * vy, bodies.x(i), bodies.y(i));
        bodies.place(i, paths.startX(i), 0, paths.startY(i), 0);
        bodies.setVelocity(i, 0, 0, 0, 0);
    }
}

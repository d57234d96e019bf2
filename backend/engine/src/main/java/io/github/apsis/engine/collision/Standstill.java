package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import java.util.BitSet;

/**
 * What lies still. Impulses of a large heap are right to nine digits, it creeps by what they miss, its contacts change by that, and
 * every tick would look for other impulses. So a heap that lies on a wall or on a fixed body stays where it is, to the bit, while none
 * of its bodies is faster than
 *
 * <pre>
 *   |v| ≤ ε |a| dt     ε = 10⁻⁵
 * </pre>
 *
 * <p>with a the acceleration without contacts. That is a static friction of ε, and it holds heaps as a whole: whoever is pushed by more
 * moves, and with him all that he touches. The next tick starts where this one did and finds its impulses right.
 */
final class Standstill {
    private static final double STILL = 1e-5;

    private final Paths paths;
    private final Touching touching;
    private final HeldBodies held;
    private int[] heap = new int[16]; // of each body: another of its heap, itself for the first
    private final BitSet slow = new BitSet(); // the first of each heap of which all are
    private final BitSet borne = new BitSet(); // the first of each heap that lies on something

    Standstill(Paths paths, Touching touching, HeldBodies held) {
        this.paths = paths;
        this.touching = touching;
        this.held = held;
    }

    /** Puts back what has hardly moved in this tick, and books it to what bears it. */
    void stop(Bodies bodies) {
        if (join(bodies)) {
            for (int i = held.next(0); i >= 0; i = held.next(i + 1)) {
                int first = first(i);
                if (slow.get(first) && borne.get(first)) {
                    stop(bodies, i);
                }
            }
        }
    }

    /** Joins the bodies that touch to heaps; returns whether any body is slow. */
    private boolean join(Bodies bodies) {
        if (bodies.count() > heap.length) {
            heap = new int[Math.max(bodies.count(), heap.length + heap.length / 8)];
        }
        slow.clear();
        borne.clear();
        for (int i = held.next(0); i >= 0; i = held.next(i + 1)) {
            heap[i] = i;
            slow.set(i, isSlow(bodies, i));
        }
        if (slow.isEmpty()) {
            return false;
        }
        for (int k = 0; k < touching.size(); k++) {
            join(bodies, touching.first(k), touching.second(k));
        }
        return true;
    }

    private void join(Bodies bodies, int a, int b) {
        if (b < 0 || bodies.isFixed(b)) {
            borne.set(first(a));
        } else if (bodies.isFixed(a)) {
            borne.set(first(b));
        } else {
            int one = first(a);
            int other = first(b);
            heap[other] = one;
            slow.set(one, slow.get(one) && slow.get(other));
            borne.set(one, borne.get(one) || borne.get(other));
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

    private boolean isSlow(Bodies bodies, int i) {
        double dt = paths.dt();
        double ax = Paths.accelerationX(bodies, i);
        double ay = Paths.accelerationY(bodies, i);
        double most = STILL * STILL * dt * dt * (ax * ax + ay * ay);
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

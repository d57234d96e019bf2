package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import java.util.Arrays;

/**
 * The first guess of the impulses that hold contacts: those of the last tick, but for the ones that stopped a blow. These would
 * throw bodies out of each other's sight.
 *
 * <p>Impulses deep in a heap are large too, but they balance. A blow is told from that by where it ends: at a body that it would
 * throw; and along from there, body by body.
 */
final class FirstGuess {
    /** How far a guess may move a body, as a share of the radii of a contact. */
    private static final double FARTHEST = 0.1;

    private final Touching touching;
    private double[] impulse = new double[0];
    private double[] push = new double[0]; // x, y of each body: the sum of its impulses
    private int candidates;
    private int[] candidate = new int[0]; // contacts whose impulse alone would throw a body

    FirstGuess(Touching touching) {
        this.touching = touching;
    }

    void fill(Bodies bodies, double dt) {
        int n = touching.size();
        if (n > impulse.length) {
            impulse = new double[Math.max(n, 2 * impulse.length)];
            candidate = new int[impulse.length];
        }
        candidates = 0;
        for (int k = 0; k < n; k++) {
            impulse[k] = touching.holding(k);
            int b = touching.second(k);
            double moves = impulse[k] * dt * (bodies.inverseMass(touching.first(k)) + inverseMass(bodies, b));
            if (!(moves <= FARTHEST * size(bodies, k))) {
                candidate[candidates++] = k;
            }
        }
        if (candidates > 0) {
            sum(bodies);
            boolean dropped = true;
            while (dropped) {
                dropped = dropThrowing(bodies, dt);
            }
        }
    }

    private void sum(Bodies bodies) {
        if (2 * bodies.count() > push.length) {
            push = new double[Math.max(2 * bodies.count(), 2 * push.length)];
        }
        Arrays.fill(push, 0, 2 * bodies.count(), 0);
        for (int k = 0; k < touching.size(); k++) {
            push(k, impulse[k]);
        }
    }

    private void push(int k, double by) {
        int a = touching.first(k);
        int b = touching.second(k);
        push[2 * a] -= by * touching.normalX(k);
        push[2 * a + 1] -= by * touching.normalY(k);
        if (b >= 0) {
            push[2 * b] += by * touching.normalX(k);
            push[2 * b + 1] += by * touching.normalY(k);
        }
    }

    private boolean dropThrowing(Bodies bodies, double dt) {
        int kept = 0;
        for (int c = 0; c < candidates; c++) {
            int k = candidate[c];
            double most = FARTHEST * size(bodies, k) / dt;
            if (speed(bodies, touching.first(k)) <= most && speed(bodies, touching.second(k)) <= most) {
                candidate[kept++] = k;
            } else {
                push(k, -impulse[k]);
                impulse[k] = 0;
            }
        }
        boolean dropped = kept < candidates;
        candidates = kept;
        return dropped;
    }

    private double speed(Bodies bodies, int i) {
        return i < 0
                ? 0
                : bodies.inverseMass(i) * Math.sqrt(push[2 * i] * push[2 * i] + push[2 * i + 1] * push[2 * i + 1]);
    }

    private static double inverseMass(Bodies bodies, int i) {
        return i < 0 ? 0 : bodies.inverseMass(i);
    }

    private double size(Bodies bodies, int k) {
        int b = touching.second(k);
        return bodies.radius(touching.first(k)) + (b < 0 ? 0 : bodies.radius(b));
    }

    /** Of the k-th contact. */
    double impulse(int k) {
        return impulse[k];
    }
}

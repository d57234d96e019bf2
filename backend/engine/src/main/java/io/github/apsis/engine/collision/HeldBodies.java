package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import java.util.BitSet;

/** The bodies with contacts at rest, in the order of their slots, and where they ended their paths before they were held. */
final class HeldBodies {
    private final BitSet held = new BitSet();
    private double[] x = new double[16];
    private double[] y = new double[16];

    /** Takes the partners of these contacts as they are now. */
    void note(Bodies bodies, Touching touching) {
        held.clear();
        for (int k = 0; k < touching.size(); k++) {
            held.set(touching.first(k));
            if (touching.second(k) >= 0) {
                held.set(touching.second(k));
            }
        }
        int count = held.cardinality();
        if (count > x.length) {
            x = new double[Math.max(count, x.length + x.length / 8)];
            y = new double[x.length];
        }
        int k = 0;
        for (int i = next(0); i >= 0; i = next(i + 1), k++) {
            x[k] = bodies.x(i);
            y[k] = bodies.y(i);
        }
    }

    /** The first of them at this slot or behind, or −1. */
    int next(int i) {
        return held.nextSetBit(i);
    }

    /** Where the {@code k}-th of them was. */
    double x(int k) {
        return x[k];
    }

    double y(int k) {
        return y[k];
    }
}

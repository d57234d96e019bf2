package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;

/**
 * How fast heaps turn: bodies that move as one turn all their contacts alike, and the impulses that hold them turn with these. So a heap
 * that nothing bears, a pile of rubble in space, is at rest where its bodies do not move past each other but for that.
 *
 * <p>The spin of a heap is the one that leaves the least of Σ |w − ω × d|² over its contacts, w how fast the partners move past each other
 * and d the way from one to the other: ω = Σ d × w / Σ d². A heap on a wall or on a fixed body has none.
 */
final class HeapSpins {
    private final Touching touching;
    private final Paths paths;
    private int[] heap = new int[0]; // of each body: another of its heap, itself for the first
    private double[] turned = new double[0]; // of the first of a heap: Σ d × w, length² / time
    private double[] size = new double[0]; // of the first of a heap: Σ d², length²; infinite where something bears it

    HeapSpins(Touching touching, Paths paths) {
        this.touching = touching;
        this.paths = paths;
    }

    /** Measures all heaps at the start of the tick. */
    void measure(Bodies bodies) {
        begin(bodies);
        for (int k = 0; k < touching.size(); k++) {
            join(bodies, touching.first(k), touching.second(k));
        }
        for (int k = 0; k < touching.size(); k++) {
            int b = touching.second(k);
            if (b >= 0) {
                add(bodies, k, touching.first(k), b);
            }
        }
    }

    private void begin(Bodies bodies) {
        if (heap.length < bodies.count()) {
            heap = new int[bodies.count() + bodies.count() / 8];
            turned = new double[heap.length];
            size = new double[heap.length];
        }
        for (int k = 0; k < touching.size(); k++) {
            begin(touching.first(k));
            begin(Math.max(0, touching.second(k)));
        }
    }

    private void begin(int i) {
        heap[i] = i;
        turned[i] = 0;
        size[i] = 0;
    }

    private void join(Bodies bodies, int a, int b) {
        if (b < 0 || bodies.isFixed(b)) {
            size[first(a)] = Double.POSITIVE_INFINITY;
        } else if (bodies.isFixed(a)) {
            size[first(b)] = Double.POSITIVE_INFINITY;
        } else if (first(a) != first(b)) {
            size[first(a)] += size[first(b)];
            heap[first(b)] = first(a);
        }
    }

    private void add(Bodies bodies, int k, int a, int b) {
        double length = bodies.radius(a) + bodies.radius(b);
        double dx = length * touching.normalX(k);
        double dy = length * touching.normalY(k);
        double wx = paths.vxAt(bodies, b, 0) - paths.vxAt(bodies, a, 0);
        double wy = paths.vyAt(bodies, b, 0) - paths.vyAt(bodies, a, 0);
        turned[first(a)] += dx * wy - dy * wx;
        size[first(a)] += length * length;
    }

    private int first(int i) {
        int first = i;
        while (heap[first] != first) {
            heap[first] = heap[heap[first]];
            first = heap[first];
        }
        return first;
    }

    /** The spin of the heap of a body with contacts, radians / time, counterclockwise. */
    double of(int i) {
        int first = first(i);
        return turned[first] / size[first];
    }
}

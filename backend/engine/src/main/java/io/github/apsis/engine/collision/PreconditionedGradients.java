package io.github.apsis.engine.collision;

import java.util.Arrays;

/**
 * Solves systems of a heap with a factor of another that is near: conjugate gradients, preconditioned by it (Hestenes and Stiefel
 * 1952, J. Res. Natl. Bur. Stand. 49, 409). Each contact that has begun or ceased to push since takes a round, and normals that have
 * turned a little a few.
 */
final class PreconditionedGradients {
    /** So many rounds cost as much as a new factor. */
    private static final int MOST_ROUNDS = 10;

    private double[] lacking = new double[0]; // v − K z
    private double[] near = new double[0]; // what the factor makes of that
    private double[] along = new double[0];
    private double[] change = new double[0]; // K · along
    private double[] speed = new double[0];

    /**
     * Solves (1 + Gᵀ W G) z = v in place.
     *
     * @param enough the most that a component of v may be missed by
     * @return whether it came so near
     */
    boolean solve(HeapMatrix heap, double[] weight, double enough, double[] v) {
        reserve(heap);
        int n = heap.unknowns();
        System.arraycopy(v, 0, lacking, 0, n);
        Arrays.fill(v, 0, n, 0);
        Arrays.fill(along, 0, n, 0);
        double before = Double.POSITIVE_INFINITY;
        for (int round = 0; round < MOST_ROUNDS; round++) {
            System.arraycopy(lacking, 0, near, 0, n);
            heap.solve(near);
            double now = dot(n, lacking, near);
            double turn = now / before;
            before = now;
            for (int i = 0; i < n; i++) {
                along[i] = near[i] + turn * along[i];
            }
            double curvature = multiply(heap, weight);
            if (!(curvature > 0)) {
                return now == 0;
            }
            double step = now / curvature;
            double worst = 0;
            for (int i = 0; i < n; i++) {
                v[i] += step * along[i];
                lacking[i] -= step * change[i];
                worst = Math.max(worst, Math.abs(lacking[i]));
            }
            if (worst <= enough) {
                return true;
            }
        }
        return false;
    }

    private void reserve(HeapMatrix heap) {
        if (heap.unknowns() > along.length) {
            int capacity = Math.max(heap.unknowns(), 2 * along.length);
            lacking = new double[capacity];
            near = new double[capacity];
            along = new double[capacity];
            change = new double[capacity];
        }
        if (heap.size() > speed.length) {
            speed = new double[Math.max(heap.size(), 2 * speed.length)];
        }
    }

    private double multiply(HeapMatrix heap, double[] weight) {
        heap.separate(along, speed);
        for (int k = 0; k < heap.size(); k++) {
            speed[k] *= weight[k];
        }
        heap.spread(speed, change);
        for (int i = 0; i < heap.unknowns(); i++) {
            change[i] += along[i];
        }
        return dot(heap.unknowns(), along, change);
    }

    private static double dot(int n, double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < n; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }
}

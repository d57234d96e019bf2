package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import java.util.Arrays;

/**
 * The {@link ContactMatrix} of a heap from the side of its bodies: A = G Gᵀ, a row g_k of G for every contact with entries for its
 * two bodies, which are velocities times √mass. Systems with 1 + Gᵀ W G, W any weights of contacts, are solved directly.
 *
 * <p>The factor stays when contacts change: of other weights and normals it is no more than near.
 */
final class HeapMatrix {
    private final HeapFactor factor = new HeapFactor();
    private boolean isAnalysed; // the factor knows where these contacts are
    private int factored; // nodes
    private int bodies;
    private int size;
    private int nodes; // bodies that contacts move, now or when the factor was made
    private int[] node = new int[0]; // of bodies
    private double[] x = new double[0];
    private double[] y = new double[0];
    private int[] first = new int[0]; // node, or −1 for what nothing moves
    private int[] second = new int[0];
    private double[] ax = new double[0];
    private double[] ay = new double[0];
    private double[] bx = new double[0];
    private double[] by = new double[0];

    /** Takes the contacts of a matrix over; a factor that was made stays. */
    void set(ContactMatrix matrix, Bodies bodies) {
        size = matrix.size();
        reserve(bodies.count());
        if (factored == 0 || bodies.count() != this.bodies) {
            factored = 0;
            nodes = 0;
            this.bodies = bodies.count();
            Arrays.fill(node, 0, bodies.count(), -1);
        }
        isAnalysed = false;
        for (int k = 0; k < size; k++) {
            int a = matrix.first(k);
            int b = matrix.second(k);
            double massA = Math.sqrt(matrix.inverseMass(matrix.firstNumber(k)));
            double massB = Math.sqrt(matrix.inverseMass(matrix.secondNumber(k)));
            first[k] = massA > 0 ? node(a, bodies) : -1;
            second[k] = massB > 0 ? node(b, bodies) : -1;
            ax[k] = -massA * matrix.normalX(k);
            ay[k] = -massA * matrix.normalY(k);
            bx[k] = massB * matrix.normalX(k);
            by[k] = massB * matrix.normalY(k);
        }
    }

    /** Forgets the factor: the contacts that are set next are numbered anew. */
    void forget() {
        factored = 0;
    }

    /** Whether there is a factor. */
    boolean isFactored() {
        return factored > 0;
    }

    private void reserve(int bodies) {
        if (bodies > node.length) {
            int capacity = Math.max(bodies, 2 * node.length);
            node = new int[capacity];
            x = new double[capacity];
            y = new double[capacity];
        }
        if (size > first.length) {
            int capacity = Math.max(size, 2 * first.length);
            first = new int[capacity];
            second = new int[capacity];
            ax = new double[capacity];
            ay = new double[capacity];
            bx = new double[capacity];
            by = new double[capacity];
        }
    }

    private int node(int i, Bodies bodies) {
        if (node[i] < 0) {
            node[i] = nodes;
            x[nodes] = bodies.x(i);
            y[nodes] = bodies.y(i);
            nodes++;
        }
        return node[i];
    }

    /** The number of contacts. */
    int size() {
        return size;
    }

    /** The number of unknown velocities, two for each body. */
    int unknowns() {
        return 2 * nodes;
    }

    /** out = G u: the separating speeds of velocities u. */
    void separate(double[] u, double[] out) {
        for (int k = 0; k < size; k++) {
            int a = 2 * first[k];
            int b = 2 * second[k];
            double speed = a < 0 ? 0 : ax[k] * u[a] + ay[k] * u[a + 1];
            out[k] = b < 0 ? speed : speed + (bx[k] * u[b] + by[k] * u[b + 1]);
        }
    }

    /** u = Gᵀ in: the velocities that impulses give. */
    void spread(double[] in, double[] u) {
        Arrays.fill(u, 0, 2 * nodes, 0);
        for (int k = 0; k < size; k++) {
            int a = 2 * first[k];
            int b = 2 * second[k];
            if (a >= 0) {
                u[a] += ax[k] * in[k];
                u[a + 1] += ay[k] * in[k];
            }
            if (b >= 0) {
                u[b] += bx[k] * in[k];
                u[b + 1] += by[k] * in[k];
            }
        }
    }

    /** Prepares {@link #solve} for weights of the contacts. */
    void factor(double[] weight) {
        if (!isAnalysed) {
            factor.analyse(nodes, x, y, size, first, second);
            isAnalysed = true;
        }
        factored = nodes;
        factor.factor(ax, ay, bx, by, weight);
    }

    /** Solves (1 + Gᵀ W G) z = v in place, as it was when the factor was made; bodies that are new since stay as they are. */
    void solve(double[] v) {
        factor.solve(v);
    }
}

package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import java.util.Arrays;

/**
 * What impulses at contacts do to the separating speeds there:
 *
 * <pre>
 *   A_kl = Σ_i ±n_k · n_l / m_i over the bodies i that contacts k and l share,     scaled to A_kk = 1
 * </pre>
 *
 * <p>The matrix is never written out: a product goes from contacts to bodies and back, in the order of the contacts: same bits,
 * always.
 */
final class ContactMatrix {
    /**
     * A body without mass is lighter than the lightest with mass by so much: more, and a stack on it could not be told from one
     * in the air.
     */
    private static final double MASSLESS = 1e9;

    private int size;
    private int bodies;
    private int[] a = new int[16];
    private int[] b = new int[16];
    private double[] hx = new double[16]; // n / √A_kk
    private double[] hy = new double[16];
    private double[] scale = new double[16]; // 1 / √A_kk

    private double[] inverseMass = new double[17]; // of bodies; the last is that of all walls
    private double[] velocity = new double[34]; // x, y of each body: what impulses give it

    /** Forgets all contacts; there will be so many at most. */
    void begin(int contacts, Bodies all) {
        size = 0;
        bodies = all.count();
        if (contacts > a.length) {
            int capacity = Math.max(contacts, 2 * a.length);
            a = new int[capacity];
            b = new int[capacity];
            hx = new double[capacity];
            hy = new double[capacity];
            scale = new double[capacity];
        }
        if (bodies >= inverseMass.length) {
            int capacity = Math.max(bodies + 1, 2 * inverseMass.length);
            inverseMass = new double[capacity];
            velocity = new double[2 * capacity];
        }
        double lightest = 0;
        for (int i = 0; i < bodies; i++) {
            inverseMass[i] = all.inverseMass(i);
            lightest = Math.max(lightest, all.mass(i) > 0 ? inverseMass[i] : 0);
        }
        double least = lightest > 0 ? MASSLESS * lightest : 1;
        for (int i = 0; i < bodies; i++) {
            inverseMass[i] = Math.min(inverseMass[i], least);
        }
        inverseMass[bodies] = 0;
    }

    /** Adds a contact; a negative second partner is a wall. Returns √A_kk: an impulse times this is as scaled. */
    double add(int first, int second, double nx, double ny) {
        int k = size++;
        a[k] = first;
        b[k] = second < 0 ? bodies : second;
        double root = Math.sqrt(inverseMass[first] + inverseMass[b[k]]);
        scale[k] = 1 / root;
        hx[k] = nx / root;
        hy[k] = ny / root;
        return root;
    }

    /**
     * out = A · in.
     *
     * @return in · A · in
     */
    double multiply(double[] in, double[] out) {
        spread(in);
        double product = 0;
        for (int k = 0; k < size; k++) {
            int i = 2 * a[k];
            int j = 2 * b[k];
            double speed = hx[k] * (velocity[j] - velocity[i]) + hy[k] * (velocity[j + 1] - velocity[i + 1]);
            out[k] = speed;
            product += in[k] * speed;
        }
        return product;
    }

    /** The velocities that these impulses give to the bodies: {@link #velocityX}, {@link #velocityY}. */
    void spread(double[] in) {
        Arrays.fill(velocity, 0, 2 * bodies + 2, 0);
        for (int k = 0; k < size; k++) {
            int i = a[k];
            int j = b[k];
            double px = in[k] * hx[k];
            double py = in[k] * hy[k];
            velocity[2 * i] -= inverseMass[i] * px;
            velocity[2 * i + 1] -= inverseMass[i] * py;
            velocity[2 * j] += inverseMass[j] * px;
            velocity[2 * j + 1] += inverseMass[j] * py;
        }
    }

    /** A bound on the norm of A: its largest row sum (Gershgorin). */
    double norm() {
        Arrays.fill(velocity, 0, 2 * bodies + 2, 0);
        for (int k = 0; k < size; k++) {
            velocity[2 * a[k]] += scale[k];
            velocity[2 * b[k]] += scale[k];
        }
        double largest = 0;
        for (int k = 0; k < size; k++) {
            double row = inverseMass[a[k]] * velocity[2 * a[k]] + inverseMass[b[k]] * velocity[2 * b[k]];
            largest = Math.max(largest, scale[k] * row);
        }
        return largest;
    }

    int size() {
        return size;
    }

    int first(int k) {
        return a[k];
    }

    /** The other body, or −1 for any wall. */
    int second(int k) {
        return b[k] == bodies ? -1 : b[k];
    }

    /** 1 / √A_kk: a speed times this is as scaled. */
    double scale(int k) {
        return scale[k];
    }

    /** The unit normal over √A_kk. */
    double normalX(int k) {
        return hx[k];
    }

    double normalY(int k) {
        return hy[k];
    }

    /** The inverse mass that a body has here. */
    double inverseMass(int i) {
        return inverseMass[i];
    }

    double velocityX(int i) {
        return velocity[2 * i];
    }

    double velocityY(int i) {
        return velocity[2 * i + 1];
    }
}

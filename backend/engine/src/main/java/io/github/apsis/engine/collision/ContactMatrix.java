package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

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
    private @Nullable Bodies bodies;
    private int[] a = new int[16];
    private int[] b = new int[16];
    private double[] hx = new double[16]; // n / √A_kk
    private double[] hy = new double[16];
    private double[] scale = new double[16]; // 1 / √A_kk

    private final PairIndex numbered = new PairIndex(); // the number of a body with contacts, as that of it and itself

    // By number, which all walls have in common: 0.
    private int numbers = 1;
    private int[] slot = new int[17];
    private double[] inverseMass = new double[17];
    private int[] degree = new int[17]; // contacts of the body
    private double[] velocity = new double[34]; // x, y: what impulses give to the body

    private double massless; // inverse mass of a body without mass; 0 until one is asked for

    /** Forgets all contacts; there will be so many at most. */
    void begin(int contacts, Bodies all) {
        bodies = all;
        numbered.clear();
        numbers = 1;
        degree[0] = 0;
        size = 0;
        if (contacts > a.length) {
            int capacity = Math.max(contacts, 2 * a.length);
            a = new int[capacity];
            b = new int[capacity];
            hx = new double[capacity];
            hy = new double[capacity];
            scale = new double[capacity];
        }
        massless = 0;
    }

    private int number(int i) {
        if (i < 0) {
            return 0;
        }
        if (numbered.put(i, i, numbers)) {
            if (numbers == slot.length) {
                slot = Arrays.copyOf(slot, 2 * numbers);
                inverseMass = Arrays.copyOf(inverseMass, 2 * numbers);
                degree = Arrays.copyOf(degree, 2 * numbers);
                velocity = new double[4 * numbers];
            }
            degree[numbers] = 0;
            slot[numbers] = i;
            inverseMass[numbers] = bodies == null ? 0 : inverseMass(bodies, i);
            return numbers++;
        }
        return numbered.find(i, i);
    }

    private double inverseMass(Bodies all, int i) {
        if (all.mass(i) > 0 || all.isFixed(i)) {
            return all.inverseMass(i);
        }
        if (massless == 0) {
            massless = inverseMassWithoutMass(all);
        }
        return massless;
    }

    private static double inverseMassWithoutMass(Bodies all) {
        double largest = 0;
        for (int i = 0; i < all.count(); i++) {
            if (all.mass(i) > 0) {
                largest = Math.max(largest, all.inverseMass(i));
            }
        }
        return largest == 0 ? 1 : MASSLESS * largest;
    }

    /** Adds a contact; a negative second partner is a wall. Returns √A_kk: an impulse times this is as scaled. */
    double add(int first, int second, double nx, double ny) {
        int k = size++;
        a[k] = number(first);
        b[k] = number(second);
        degree[a[k]]++;
        degree[b[k]]++;
        double root = Math.sqrt(inverseMass[a[k]] + inverseMass[b[k]]);
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
        Arrays.fill(velocity, 0, 2 * numbers, 0);
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
        Arrays.fill(velocity, 0, 2 * numbers, 0);
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

    /** Whether neither partner of a contact has another contact, but for walls and fixed bodies. */
    boolean isAlone(int k) {
        return (degree[a[k]] == 1 || inverseMass[a[k]] == 0) && (degree[b[k]] == 1 || inverseMass[b[k]] == 0);
    }

    int size() {
        return size;
    }

    int first(int k) {
        return slot[a[k]];
    }

    /** The other body, or −1 for any wall. */
    int second(int k) {
        return b[k] == 0 ? -1 : slot[b[k]];
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

    /** The number of the first body of a contact. Numbers stand for bodies with contacts, in the order of these. */
    int firstNumber(int k) {
        return a[k];
    }

    /** The same of the second, 0 for any wall. */
    int secondNumber(int k) {
        return b[k];
    }

    /** One more than the last number; the first of a body is 1. */
    int numbers() {
        return numbers;
    }

    /** The body of a number. */
    int slot(int number) {
        return slot[number];
    }

    /** The inverse mass that a body has here, 0 for the walls. */
    double inverseMass(int number) {
        return inverseMass[number];
    }

    /** Of a body, 0 for the walls. */
    double velocityX(int number) {
        return velocity[2 * number];
    }

    double velocityY(int number) {
        return velocity[2 * number + 1];
    }
}

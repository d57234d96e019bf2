package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import java.util.Arrays;

/**
 * The impulses λ of many contacts at once, which push and never pull, and leave no contact with less than its wanted speed:
 *
 * <pre>
 *   w = c + A λ ≥ 0     λ ≥ 0     λ · w = 0          A_kl = Σ_i ±n_k · n_l / m_i over the bodies i that k and l share
 * </pre>
 *
 * <p>c is what each contact lacks without impulses, negative where it closes. λ minimises ½ λ·Aλ + c·λ, which for c = the
 * separating speeds is the change of kinetic energy. The method is MPRGP (Dostál 2009, "Optimal Quadratic Programming
 * Algorithms", chapter 5): conjugate gradients on the contacts that push, projected steps where one begins or ends to. It
 * needs about the square root of the rounds of sequential impulses, and about as many as there are heavy bodies where these lie
 * on light ones. Contacts are scaled to unit A_kk. A round costs two passes over the contacts and keeps their order: same bits,
 * always.
 */
final class ImpulseSolver {
    /** Of the gradient at contacts that push, against that at those which might begin to: Dostál's Γ. */
    private static final double PROPORTION = 1;

    /** Impulses that miss by no more than so many tolerances stay as they are: rounding alone would have them found anew. */
    private static final double GOOD_ENOUGH = 4;

    /** Squares of such speeds are still numbers; what is faster is left to the walls. */
    private static final double FASTEST = 1e100;

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
    private double[] lack = new double[16]; // c / √A_kk
    private double[] applied = new double[16]; // the impulses that the bodies already have, as those are written
    private double[] impulse = new double[16]; // λ √A_kk
    private double[] gradient = new double[16]; // w / √A_kk
    private double[] along = new double[16]; // the direction of a round
    private double[] change = new double[16]; // A · along

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
            lack = new double[capacity];
            applied = new double[capacity];
            impulse = new double[capacity];
            gradient = new double[capacity];
            along = new double[capacity];
            change = new double[capacity];
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

    /**
     * Adds a contact.
     *
     * @param second the other body, or a wall as a negative number
     * @param nx of the unit normal from the first to the second
     * @param guess of its impulse, 0 or more
     */
    void add(int first, int second, double nx, double ny, double guess) {
        int k = size++;
        a[k] = first;
        b[k] = second < 0 ? bodies : second;
        double root = Math.sqrt(inverseMass[first] + inverseMass[b[k]]);
        scale[k] = 1 / root;
        hx[k] = nx / root;
        hy[k] = ny / root;
        impulse[k] = guess * root;
        applied[k] = 0;
    }

    /** Computes what the impulses do to the bodies beyond what was computed before: {@link #pushX}, {@link #pushY}. */
    void push() {
        for (int k = 0; k < size; k++) {
            along[k] = impulse[k] - applied[k];
            applied[k] = impulse[k];
        }
        spread(along);
    }

    /** Tells the separating speed that a contact has, beyond what it should have, with the impulses that were pushed so far. */
    void measured(int k, double speed) {
        gradient[k] = speed * scale[k];
    }

    /**
     * Finds the impulses, from the speeds as they were measured.
     *
     * @param tolerance the speed by which a contact may miss what it should have, as a share of the most that one would miss
     *     without impulses
     * @param rounding the speed below which there is nothing to be found
     * @param mostRounds after which the best so far has to do
     * @return how many rounds it took; 0 when the impulses were right
     */
    int solve(double tolerance, double rounding, int mostRounds) {
        double most = separate();
        double allowed = Math.max(rounding, tolerance * most);
        double error = error();
        if (error <= GOOD_ENOUGH * allowed || most > FASTEST) {
            return 0;
        }
        double longest = 1.8 / largestRow();
        restart();
        int rounds = 0;
        while (error > allowed && rounds < mostRounds) {
            rounds++;
            boolean moved = isProportional(longest) ? slide(longest) : release();
            if (!moved) {
                break;
            }
            error = error();
        }
        limitEnergy();
        return rounds;
    }

    /** The same from speeds that were measured without impulses. */
    int solveFrom(double tolerance, int mostRounds) {
        multiply(impulse, change);
        for (int k = 0; k < size; k++) {
            gradient[k] += change[k];
        }
        return solve(tolerance, 0, mostRounds);
    }

    /** c = w − A λ, and the most that a contact misses without impulses. */
    private double separate() {
        multiply(impulse, lack);
        double most = 0;
        for (int k = 0; k < size; k++) {
            lack[k] = gradient[k] - lack[k];
            most = Math.max(most, -lack[k] / scale[k]);
        }
        return most;
    }

    /** w = c + A λ afresh. */
    private void refreshGradient() {
        multiply(impulse, gradient);
        for (int k = 0; k < size; k++) {
            gradient[k] += lack[k];
        }
    }

    /** out = A · in. */
    private void multiply(double[] in, double[] out) {
        spread(in);
        for (int k = 0; k < size; k++) {
            int i = 2 * a[k];
            int j = 2 * b[k];
            out[k] = hx[k] * (velocity[j] - velocity[i]) + hy[k] * (velocity[j + 1] - velocity[i + 1]);
        }
    }

    /** The velocities that these impulses give to the bodies. */
    private void spread(double[] in) {
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
    private double largestRow() {
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

    /** The next direction is the gradient of the contacts that push. */
    private void restart() {
        for (int k = 0; k < size; k++) {
            along[k] = impulse[k] > 0 ? gradient[k] : 0;
        }
    }

    /** The largest speed by which a contact misses what it should have. */
    private double error() {
        double largest = 0;
        for (int k = 0; k < size; k++) {
            double w = impulse[k] > 0 ? Math.abs(gradient[k]) : -gradient[k];
            largest = Math.max(largest, w / scale[k]);
        }
        return largest;
    }

    /** Whether the contacts that push are more wrong than those that should begin to. */
    private boolean isProportional(double longest) {
        double pushing = 0;
        double waiting = 0;
        for (int k = 0; k < size; k++) {
            double g = gradient[k];
            if (impulse[k] > 0) {
                pushing += g * Math.min(impulse[k] / longest, g);
            } else if (g < 0) {
                waiting += g * g;
            }
        }
        return waiting <= PROPORTION * PROPORTION * pushing;
    }

    /**
     * A step of conjugate gradients among the contacts that push; where it meets the end of a push, a projected one.
     *
     * @return false when the numbers are too small for squares
     */
    private boolean slide(double longest) {
        multiply(along, change);
        double curvature = dot(along, change);
        if (!(curvature > 0)) {
            return false;
        }
        double step = dot(gradient, along) / curvature;
        double feasible = Double.POSITIVE_INFINITY;
        for (int k = 0; k < size; k++) {
            if (along[k] > 0) {
                feasible = Math.min(feasible, impulse[k] / along[k]);
            }
        }
        if (step <= feasible) {
            move(step);
            double turn = turn(curvature);
            for (int k = 0; k < size; k++) {
                along[k] = impulse[k] > 0 ? gradient[k] - turn * along[k] : 0;
            }
        } else {
            move(feasible);
            for (int k = 0; k < size; k++) {
                if (impulse[k] > 0) {
                    impulse[k] = Math.max(0, impulse[k] - longest * gradient[k]);
                }
            }
            refreshGradient();
            restart();
        }
        return true;
    }

    /** (φ · A p) / (p · A p), which makes the next direction conjugate to this one. */
    private double turn(double curvature) {
        double sum = 0;
        for (int k = 0; k < size; k++) {
            sum += impulse[k] > 0 ? gradient[k] * change[k] : 0;
        }
        return sum / curvature;
    }

    /** Lets those contacts begin to push that should. */
    private boolean release() {
        for (int k = 0; k < size; k++) {
            along[k] = impulse[k] > 0 ? 0 : Math.min(0, gradient[k]);
        }
        multiply(along, change);
        double curvature = dot(along, change);
        if (!(curvature > 0)) {
            return false;
        }
        move(dot(gradient, along) / curvature);
        restart();
        return true;
    }

    private void move(double step) {
        for (int k = 0; k < size; k++) {
            impulse[k] = Math.max(0, impulse[k] - step * along[k]);
            gradient[k] -= step * change[k];
        }
    }

    /** Impulses that are not found yet must not add energy: then they are cut to the share that takes most. */
    private void limitEnergy() {
        double bent = 0; // λ·Aλ
        double gained = 0; // c·λ, negative when energy leaves
        for (int k = 0; k < size; k++) {
            bent += impulse[k] * (gradient[k] - lack[k]);
            gained += impulse[k] * lack[k];
        }
        if (0.5 * bent + gained > 0) {
            double share = Math.max(0, -gained / bent);
            for (int k = 0; k < size; k++) {
                impulse[k] *= share;
            }
        }
    }

    private double dot(double[] u, double[] v) {
        double sum = 0;
        for (int k = 0; k < size; k++) {
            sum += u[k] * v[k];
        }
        return sum;
    }

    /** The impulse of the k-th contact that was added. */
    double impulse(int k) {
        return impulse[k] * scale[k];
    }

    /** λ · A λ: twice the kinetic energy that the impulses alone would give. */
    double selfWork() {
        multiply(impulse, change);
        return dot(impulse, change);
    }

    /** Multiplies all impulses. */
    void scaleBy(double factor) {
        for (int k = 0; k < size; k++) {
            impulse[k] *= factor;
        }
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

    /** The part of an impulse that {@link #push} has yet to pass on, as a vector on the second partner. */
    double unpushedX(int k) {
        return (impulse[k] - applied[k]) * hx[k];
    }

    double unpushedY(int k) {
        return (impulse[k] - applied[k]) * hy[k];
    }

    /** The inverse mass that a body has here. */
    double inverseMass(int i) {
        return inverseMass[i];
    }

    /** The change of velocity of a body. */
    double pushX(int i) {
        return velocity[2 * i];
    }

    double pushY(int i) {
        return velocity[2 * i + 1];
    }
}

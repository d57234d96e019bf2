package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;

/**
 * The impulses λ of many contacts at once, which push and never pull, and leave no contact with less than its wanted speed:
 *
 * <pre>
 *   w = c + A λ ≥ 0     λ ≥ 0     λ · w = 0
 * </pre>
 *
 * <p>c is what each contact lacks without impulses, negative where it closes. λ minimises ½ λ·Aλ + c·λ, which for c = the
 * separating speeds is the change of kinetic energy. The method is MPRGP (Dostál 2009, "Optimal Quadratic Programming
 * Algorithms", chapter 5): conjugate gradients on the contacts that push, projected steps where one begins or ends to. It
 * needs about the square root of the rounds of sequential impulses, and about as many as there are heavy bodies where these lie
 * on light ones. A heap that is to come to rest needs more than that: {@link HeapSolver}.
 */
final class ImpulseSolver {
    /** Of the gradient at contacts that push, against that at those which might begin to: Dostál's Γ. */
    private static final double PROPORTION = 1;

    /** Impulses that miss by no more than so many tolerances stay as they are: rounding alone would have them found anew. */
    static final double GOOD_ENOUGH = 4;

    /** Squares of such speeds are still numbers; what is faster is left to the walls. */
    private static final double FASTEST = 1e100;

    /** What is solved directly may miss so much of the most that a contact lacks. */
    private static final double DIRECT_TOLERANCE = 1e-9;

    /** So many contacts and more are solved directly after few rounds, since a factor costs less than the other rounds. */
    static final int MANY = 500;

    private static final int FEW_ROUNDS = 20;

    /** Of the most that a contact lacks: what misses less is better found without them. */
    private static final double NEAR = 1e-2;

    // All scaled as the matrix is.
    private final ContactMatrix matrix = new ContactMatrix();
    private double[] lack = new double[16]; // c
    private double[] applied = new double[16]; // the impulses that the bodies already have
    private double[] impulse = new double[16]; // λ
    private double[] gradient = new double[16]; // w
    private double[] along = new double[16]; // the direction of a round
    private double[] change = new double[16]; // A · along

    // Of the present impulses.
    private double longest; // step of steepest descent
    private double most; // speed that a contact misses without impulses
    private double allowed; // error
    private double error; // the largest speed by which a contact misses what it should have
    private double pushing; // how wrong contacts are that push, and
    private double waiting; // those that should begin to

    /** Forgets all contacts; there will be so many at most. */
    void begin(int contacts, Bodies all) {
        matrix.begin(contacts, all);
        if (contacts > impulse.length) {
            int capacity = Math.max(contacts, 2 * impulse.length);
            lack = new double[capacity];
            applied = new double[capacity];
            impulse = new double[capacity];
            gradient = new double[capacity];
            along = new double[capacity];
            change = new double[capacity];
        }
    }

    /**
     * Adds a contact.
     *
     * @param second the other body, or a wall as a negative number
     * @param nx of the unit normal from the first to the second
     * @param guess of its impulse, 0 or more
     */
    void add(int first, int second, double nx, double ny, double guess) {
        int k = matrix.size();
        impulse[k] = guess * matrix.add(first, second, nx, ny);
        applied[k] = 0;
    }

    /** Computes what the impulses do to the bodies beyond what was computed before: {@link #pushX}, {@link #pushY}. */
    void push() {
        for (int k = 0; k < size(); k++) {
            along[k] = impulse[k] - applied[k];
            applied[k] = impulse[k];
        }
        matrix.spread(along);
    }

    /** Tells the separating speed that a contact has, beyond what it should have, with the impulses that were pushed so far. */
    void measured(int k, double speed) {
        gradient[k] = speed * matrix.scale(k);
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
        if (areRight(tolerance, rounding)) {
            return 0;
        }
        int rounds = descend(mostRounds);
        limitEnergy();
        return rounds;
    }

    /** The same for a heap that is to come to rest: what rounds do not find is found directly, which counts as one. */
    int solveDirectly(HeapSolver heap, Bodies bodies, double tolerance, double rounding, int mostRounds) {
        boolean many = size() >= MANY;
        if (areRight(many ? Math.max(tolerance, DIRECT_TOLERANCE) : tolerance, rounding)) {
            return 0;
        }
        int rounds = 0;
        if (!many || error > NEAR * most) {
            rounds = descend(many ? FEW_ROUNDS : mostRounds);
        }
        if (error > allowed) {
            rounds++;
            if (!improve(heap, bodies)) {
                rounds += descend(mostRounds - rounds);
            }
        }
        limitEnergy();
        return rounds;
    }

    /** Measures the present impulses; returns whether they may stay. */
    private boolean areRight(double tolerance, double rounding) {
        most = separate();
        allowed = Math.max(rounding, tolerance * most);
        error = error();
        if (error <= GOOD_ENOUGH * allowed || most > FASTEST) {
            return true;
        }
        longest = 1.8 / matrix.norm();
        assess();
        return false;
    }

    private double error() {
        double largest = 0;
        for (int k = 0; k < size(); k++) {
            double w = gradient[k];
            double misses = impulse[k] > 0 ? Math.abs(w) : -w;
            largest = Math.max(largest, misses / matrix.scale(k));
        }
        return largest;
    }

    private int descend(int mostRounds) {
        restart();
        int rounds = 0;
        while (error > allowed && rounds < mostRounds) {
            rounds++;
            boolean moved = waiting <= PROPORTION * PROPORTION * pushing ? slide() : release();
            if (!moved) {
                break;
            }
        }
        return rounds;
    }

    /** Returns whether it has found better impulses. */
    private boolean improve(HeapSolver heap, Bodies bodies) {
        double mostScaled = 0;
        double leastScale = Double.POSITIVE_INFINITY;
        for (int k = 0; k < size(); k++) {
            mostScaled = Math.max(mostScaled, -lack[k]);
            leastScale = Math.min(leastScale, matrix.scale(k));
        }
        if (mostScaled == 0) {
            return false;
        }
        double enough = Math.max(leastScale * allowed, DIRECT_TOLERANCE * mostScaled);
        double before = error;
        System.arraycopy(impulse, 0, along, 0, size());
        heap.improve(matrix, bodies, lack, mostScaled, enough, impulse);
        measureAgain();
        boolean better = error < before;
        if (!better) {
            System.arraycopy(along, 0, impulse, 0, size());
            measureAgain();
        }
        return better;
    }

    private void measureAgain() {
        matrix.multiply(impulse, gradient);
        for (int k = 0; k < size(); k++) {
            gradient[k] += lack[k];
        }
        assess();
    }

    /** The same from speeds that were measured without impulses. */
    int solveFrom(double tolerance, int mostRounds) {
        matrix.multiply(impulse, change);
        for (int k = 0; k < size(); k++) {
            gradient[k] += change[k];
        }
        return solve(tolerance, 0, mostRounds);
    }

    /** The same for a heap that is to come to rest. */
    int solveFromDirectly(HeapSolver heap, Bodies bodies, double tolerance, int mostRounds) {
        matrix.multiply(impulse, change);
        for (int k = 0; k < size(); k++) {
            gradient[k] += change[k];
        }
        return solveDirectly(heap, bodies, tolerance, 0, mostRounds);
    }

    /** c = w − A λ, and the most that a contact misses without impulses. */
    private double separate() {
        matrix.multiply(impulse, lack);
        double most = 0;
        for (int k = 0; k < size(); k++) {
            lack[k] = gradient[k] - lack[k];
            most = Math.max(most, -lack[k] / matrix.scale(k));
        }
        return most;
    }

    /** Measures how far the impulses are from right. */
    private void assess() {
        error = 0;
        pushing = 0;
        waiting = 0;
        for (int k = 0; k < size(); k++) {
            assess(k);
        }
    }

    private void assess(int k) {
        double w = gradient[k];
        if (impulse[k] > 0) {
            pushing += w * Math.min(impulse[k] / longest, w);
            error = Math.max(error, Math.abs(w) / matrix.scale(k));
        } else if (w < 0) {
            waiting += w * w;
            error = Math.max(error, -w / matrix.scale(k));
        }
    }

    /** The next direction is the gradient of the contacts that push. */
    private void restart() {
        for (int k = 0; k < size(); k++) {
            along[k] = impulse[k] > 0 ? gradient[k] : 0;
        }
    }

    /**
     * A step of conjugate gradients among the contacts that push; where it meets the end of a push, a projected one.
     *
     * @return false when the numbers are too small for squares
     */
    private boolean slide() {
        double curvature = matrix.multiply(along, change);
        if (!(curvature > 0)) {
            return false;
        }
        double slope = 0;
        double feasible = Double.POSITIVE_INFINITY;
        for (int k = 0; k < size(); k++) {
            slope += gradient[k] * along[k];
            if (along[k] > 0) {
                feasible = Math.min(feasible, impulse[k] / along[k]);
            }
        }
        double step = slope / curvature;
        if (step <= feasible) {
            move(step);
            turn(curvature);
        } else {
            expand(feasible);
        }
        return true;
    }

    /** The next direction is conjugate to this one: φ − (φ · A p) / (p · A p) p. */
    private void turn(double curvature) {
        double sum = 0;
        for (int k = 0; k < size(); k++) {
            sum += impulse[k] > 0 ? gradient[k] * change[k] : 0;
        }
        double turn = sum / curvature;
        for (int k = 0; k < size(); k++) {
            along[k] = impulse[k] > 0 ? gradient[k] - turn * along[k] : 0;
        }
    }

    /**
     * Goes as far as no push turns to a pull, and from there down the gradient, past the end of some. To take the whole step and
     * cut off what pulls is sooner exact, but in a heap that has to do with few rounds it leaves too many contacts without a push.
     */
    private void expand(double feasible) {
        for (int k = 0; k < size(); k++) {
            impulse[k] = Math.max(0, impulse[k] - feasible * along[k]);
            if (impulse[k] > 0) {
                impulse[k] = Math.max(0, impulse[k] - longest * (gradient[k] - feasible * change[k]));
            }
        }
        measureAgain();
        restart();
    }

    /** Lets those contacts begin to push that should. */
    private boolean release() {
        for (int k = 0; k < size(); k++) {
            along[k] = impulse[k] > 0 ? 0 : Math.min(0, gradient[k]);
        }
        double curvature = matrix.multiply(along, change);
        if (!(curvature > 0)) {
            return false;
        }
        double slope = 0;
        for (int k = 0; k < size(); k++) {
            slope += gradient[k] * along[k];
        }
        move(slope / curvature);
        restart();
        return true;
    }

    private void move(double step) {
        error = 0;
        pushing = 0;
        waiting = 0;
        for (int k = 0; k < size(); k++) {
            impulse[k] = Math.max(0, impulse[k] - step * along[k]);
            gradient[k] -= step * change[k];
            assess(k);
        }
    }

    /** Impulses that are not found yet must not add energy: then they are cut to the share that takes most. */
    private void limitEnergy() {
        double bent = 0; // λ·Aλ
        double gained = 0; // c·λ, negative when energy leaves
        for (int k = 0; k < size(); k++) {
            bent += impulse[k] * (gradient[k] - lack[k]);
            gained += impulse[k] * lack[k];
        }
        if (0.5 * bent + gained > 0) {
            double share = Math.max(0, -gained / bent);
            for (int k = 0; k < size(); k++) {
                impulse[k] *= share;
            }
        }
    }

    /** The impulse of the k-th contact that was added. */
    double impulse(int k) {
        return impulse[k] * matrix.scale(k);
    }

    /** λ · A λ: twice the kinetic energy that the impulses alone would give. */
    double selfWork() {
        return matrix.multiply(impulse, change);
    }

    /** Multiplies all impulses. */
    void scaleBy(double factor) {
        for (int k = 0; k < size(); k++) {
            impulse[k] *= factor;
        }
    }

    int size() {
        return matrix.size();
    }

    int first(int k) {
        return matrix.first(k);
    }

    /** The other body, or −1 for any wall. */
    int second(int k) {
        return matrix.second(k);
    }

    /** The part of an impulse that {@link #push} has yet to pass on, as a vector on the second partner. */
    double unpushedX(int k) {
        return (impulse[k] - applied[k]) * matrix.normalX(k);
    }

    double unpushedY(int k) {
        return (impulse[k] - applied[k]) * matrix.normalY(k);
    }

    /** The inverse mass that a body has here. */
    double inverseMass(int i) {
        return matrix.inverseMass(i);
    }

    /** The change of velocity of a body. */
    double pushX(int i) {
        return matrix.velocityX(i);
    }

    double pushY(int i) {
        return matrix.velocityY(i);
    }
}

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
 * separating speeds is the change of kinetic energy. {@link BoundedGradients} need about the square root of the rounds of sequential
 * impulses, and about as many as there are heavy bodies where these lie on light ones. A heap that is to come to rest needs more
 * than that: {@link HeapSolver}.
 */
final class ImpulseSolver {
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
    private final BoundedGradients gradients = new BoundedGradients(matrix);
    private double[] applied = new double[16]; // the impulses that the bodies already have
    private double[] scratch = new double[16];

    private double most; // speed that a contact misses without impulses
    private double allowed; // error

    /** Forgets all contacts; there will be so many at most. */
    void begin(int contacts, Bodies all) {
        matrix.begin(contacts, all);
        gradients.reserve(contacts);
        if (contacts > applied.length) {
            int capacity = Math.max(contacts, 2 * applied.length);
            applied = new double[capacity];
            scratch = new double[capacity];
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
        gradients.impulse[k] = guess * matrix.add(first, second, nx, ny);
        applied[k] = 0;
    }

    /** Computes what the impulses do to the bodies beyond what was computed before: {@link #pushX}, {@link #pushY}. */
    void push() {
        double[] impulse = gradients.impulse;
        for (int k = 0; k < size(); k++) {
            scratch[k] = impulse[k] - applied[k];
            applied[k] = impulse[k];
        }
        matrix.spread(scratch);
    }

    /** Tells the separating speed that a contact has, beyond what it should have, with the impulses that were pushed so far. */
    void measured(int k, double speed) {
        gradients.gradient[k] = speed * matrix.scale(k);
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
        int rounds = gradients.descend(allowed, mostRounds);
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
        if (!many || gradients.error() > NEAR * most) {
            rounds = gradients.descend(allowed, many ? FEW_ROUNDS : mostRounds);
        }
        if (gradients.error() > allowed) {
            rounds++;
            if (!improve(heap, bodies)) {
                rounds += gradients.descend(allowed, mostRounds - rounds);
            }
        }
        limitEnergy();
        return rounds;
    }

    /** Measures the present impulses; returns whether they may stay. */
    private boolean areRight(double tolerance, double rounding) {
        most = gradients.separate();
        allowed = Math.max(rounding, tolerance * most);
        gradients.assess();
        if (gradients.error() <= GOOD_ENOUGH * allowed || most > FASTEST) {
            return true;
        }
        gradients.begin();
        return false;
    }

    /** Returns whether it has found better impulses. */
    private boolean improve(HeapSolver heap, Bodies bodies) {
        double mostScaled = 0;
        double leastScale = Double.POSITIVE_INFINITY;
        for (int k = 0; k < size(); k++) {
            mostScaled = Math.max(mostScaled, -gradients.lack[k]);
            leastScale = Math.min(leastScale, matrix.scale(k));
        }
        if (mostScaled == 0) {
            return false;
        }
        double enough = Math.max(leastScale * allowed, DIRECT_TOLERANCE * mostScaled);
        double before = gradients.error();
        System.arraycopy(gradients.impulse, 0, scratch, 0, size());
        heap.improve(matrix, bodies, gradients.lack, mostScaled, enough, gradients.impulse);
        gradients.measureAgain();
        boolean better = gradients.error() < before;
        if (!better) {
            System.arraycopy(scratch, 0, gradients.impulse, 0, size());
            gradients.measureAgain();
        }
        return better;
    }

    /** The same from speeds that were measured without impulses. */
    int solveFrom(double tolerance, int mostRounds) {
        gradients.multiplyIn();
        return solve(tolerance, 0, mostRounds);
    }

    /** The same for a heap that is to come to rest. */
    int solveFromDirectly(HeapSolver heap, Bodies bodies, double tolerance, int mostRounds) {
        gradients.multiplyIn();
        return solveDirectly(heap, bodies, tolerance, 0, mostRounds);
    }

    /** Impulses that are not found yet must not add energy: then they are cut to the share that takes most. */
    private void limitEnergy() {
        double[] impulse = gradients.impulse;
        double bent = 0; // λ·Aλ
        double gained = 0; // c·λ, negative when energy leaves
        for (int k = 0; k < size(); k++) {
            bent += impulse[k] * (gradients.gradient[k] - gradients.lack[k]);
            gained += impulse[k] * gradients.lack[k];
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
        return gradients.impulse[k] * matrix.scale(k);
    }

    /** λ · A λ: twice the kinetic energy that the impulses alone would give. */
    double selfWork() {
        return matrix.multiply(gradients.impulse, scratch);
    }

    /** Multiplies all impulses. */
    void scaleBy(double factor) {
        for (int k = 0; k < size(); k++) {
            gradients.impulse[k] *= factor;
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
        return (gradients.impulse[k] - applied[k]) * matrix.normalX(k);
    }

    double unpushedY(int k) {
        return (gradients.impulse[k] - applied[k]) * matrix.normalY(k);
    }

    /** The number of the first body of a contact: bodies are numbered from 1 on, in the order of the contacts. */
    int firstNumber(int k) {
        return matrix.firstNumber(k);
    }

    /** The same of the second, 0 for any wall. */
    int secondNumber(int k) {
        return matrix.secondNumber(k);
    }

    /** One more than the last number. */
    int numbers() {
        return matrix.numbers();
    }

    /** The body of a number. */
    int slot(int number) {
        return matrix.slot(number);
    }

    /** Whether neither partner of a contact has another one that could move it. */
    boolean isAlone(int k) {
        return matrix.isAlone(k);
    }

    /** The inverse mass that a body has here. */
    double inverseMass(int number) {
        return matrix.inverseMass(number);
    }

    /** The change of velocity of a body, 0 for the walls. */
    double pushX(int number) {
        return matrix.velocityX(number);
    }

    double pushY(int number) {
        return matrix.velocityY(number);
    }
}

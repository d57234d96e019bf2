package io.github.apsis.engine.collision;

/**
 * The impulses λ of a heap whose contact matrix is all but singular, where conjugate gradients would take tens of thousands of
 * rounds:
 *
 * <pre>
 *   w = c + G u + ε λ ≥ 0     u = Gᵀ λ     λ ≥ 0     λ_k w_k = μ → 0
 * </pre>
 *
 * <p>Newton's method goes along the curve of positive λ and w that μ draws, with a predictor, a corrector (Mehrotra 1992, SIAM J.
 * Optim. 2, 575) and one more (Gondzio 1996, Comput. Optim. Appl. 6, 137). It takes 20 to 30 factors, however deep the heap.
 */
final class InteriorPoint {
    /** √μ at which it ends, as a share of the most that a contact lacks, */
    private static final double END = 1e-8;

    /** or of what a contact may miss, which is more where bodies move. */
    private static final double OF_ALLOWED = 0.1;

    /** ε: contacts yield by this, in the unit of A: bodies jammed between others would else be pressed without limit. */
    private static final double YIELD = 1e-11;

    private static final int MOST_STEPS = 60;

    /** Impulses and speeds at the start, in the same unit: in a deep heap most push harder than one contact lacks. */
    private static final double FIRST_IMPULSE = 10;

    private static final double FIRST_SPEED = 0.1;

    /** Of the way to where the first λ or w would be 0. */
    private static final double SHORT_OF = 0.995;

    /** By how much longer a step the last corrector tries for, and the least by which it has to be. */
    private static final double LONGER = 0.1;

    private static final double LEAST_LONGER = 0.02;

    /** The products λ w that it leaves alone, in units of their goal: from the one to its inverse. */
    private static final double NEAR_GOAL = 0.1;

    private double[] impulse = new double[0]; // λ
    private double[] speed = new double[0]; // w
    private double[] impulseStep = new double[0];
    private double[] speedStep = new double[0];
    private double[] longerImpulseStep = new double[0];
    private double[] longerSpeedStep = new double[0];
    private double[] missing = new double[0]; // w − c − G u − ε λ
    private double[] product = new double[0]; // what a step should add to λ w
    private double[] scratch = new double[0];
    private double[] u = new double[0];
    private double[] spread = new double[0]; // Gᵀ λ
    private double[] uStep = new double[0];
    private double[] longerUStep = new double[0];
    private double toSpeed; // the part of a step at which the first w is 0
    private double toImpulse; // and the first λ

    /**
     * Finds the impulses.
     *
     * @param lack c, scaled as the matrix
     * @param most −c of the contact that lacks most, over 0
     * @param allowed the speed by which a contact may miss what it should have
     * @param found where the impulses go, if it comes to an end
     * @return whether it does
     */
    boolean solve(HeapMatrix heap, double[] lack, double most, double allowed, double[] found) {
        reserve(heap);
        int n = heap.size();
        for (int i = 0; i < heap.unknowns(); i++) {
            u[i] = 0;
        }
        for (int k = 0; k < n; k++) {
            impulse[k] = FIRST_IMPULSE * most;
            speed[k] = Math.max(lack[k], FIRST_SPEED * most);
        }
        double end = Math.max(END * most, OF_ALLOWED * allowed);
        double goal = end * end;
        double mu = measure(heap, lack);
        for (int step = 0; step < MOST_STEPS && mu > goal; step++) {
            step(heap, mu);
            mu = measure(heap, lack);
        }
        if (!(mu <= goal)) {
            return false;
        }
        for (int k = 0; k < n; k++) {
            found[k] = impulse[k] < speed[k] ? 0 : impulse[k];
        }
        return true;
    }

    private void reserve(HeapMatrix heap) {
        if (heap.size() > impulse.length) {
            int capacity = Math.max(heap.size(), 2 * impulse.length);
            impulse = new double[capacity];
            speed = new double[capacity];
            impulseStep = new double[capacity];
            speedStep = new double[capacity];
            longerImpulseStep = new double[capacity];
            longerSpeedStep = new double[capacity];
            missing = new double[capacity];
            product = new double[capacity];
            scratch = new double[capacity];
        }
        if (heap.unknowns() > u.length) {
            int capacity = Math.max(heap.unknowns(), 2 * u.length);
            u = new double[capacity];
            spread = new double[capacity];
            uStep = new double[capacity];
            longerUStep = new double[capacity];
        }
    }

    /** Measures what is missing; the mean of λ w is returned. */
    private double measure(HeapMatrix heap, double[] lack) {
        heap.spread(impulse, spread);
        heap.separate(u, missing);
        double sum = 0;
        for (int k = 0; k < heap.size(); k++) {
            missing[k] = speed[k] - lack[k] - missing[k] - YIELD * impulse[k];
            sum += impulse[k] * speed[k];
        }
        return sum / heap.size();
    }

    private void step(HeapMatrix heap, double mu) {
        int n = heap.size();
        for (int k = 0; k < n; k++) {
            scratch[k] = impulse[k] / (speed[k] + YIELD * impulse[k]);
            product[k] = -impulse[k] * speed[k];
        }
        heap.factor(scratch);
        direct(heap);
        double after = 0;
        for (int k = 0; k < n; k++) {
            after += (impulse[k] + toImpulse * impulseStep[k]) * (speed[k] + toSpeed * speedStep[k]);
        }
        double share = after / n / mu;
        double goal = share * share * share * mu;
        for (int k = 0; k < n; k++) {
            product[k] = goal - impulse[k] * speed[k] - impulseStep[k] * speedStep[k];
        }
        direct(heap);
        lengthen(heap, goal);
        double along = Math.min(1, SHORT_OF * toSpeed);
        for (int i = 0; i < heap.unknowns(); i++) {
            u[i] += along * uStep[i];
        }
        double alongImpulse = Math.min(1, SHORT_OF * toImpulse);
        for (int k = 0; k < n; k++) {
            impulse[k] += alongImpulse * impulseStep[k];
            speed[k] += along * speedStep[k];
        }
    }

    /** The step that would take off what is missing and add the wanted products. */
    private void direct(HeapMatrix heap) {
        for (int k = 0; k < heap.size(); k++) {
            scratch[k] = (product[k] + impulse[k] * missing[k]) / (speed[k] + YIELD * impulse[k]);
        }
        heap.spread(scratch, uStep);
        for (int i = 0; i < heap.unknowns(); i++) {
            uStep[i] += spread[i] - u[i];
        }
        heap.solve(uStep);
        heap.separate(uStep, speedStep);
        for (int k = 0; k < heap.size(); k++) {
            speedStep[k] -= missing[k];
            impulseStep[k] = (product[k] - impulse[k] * speedStep[k]) / (speed[k] + YIELD * impulse[k]);
            speedStep[k] += YIELD * impulseStep[k];
        }
        toSpeed = reach(heap, speed, speedStep);
        toImpulse = reach(heap, impulse, impulseStep);
    }

    private static double reach(HeapMatrix heap, double[] value, double[] step) {
        double reach = 1;
        for (int k = 0; k < heap.size(); k++) {
            if (step[k] < 0) {
                reach = Math.min(reach, -value[k] / step[k]);
            }
        }
        return reach;
    }

    /** Brings those products nearer to the goal that would stop a longer step. */
    private void lengthen(HeapMatrix heap, double goal) {
        double farSpeed = Math.min(1, toSpeed + LONGER);
        double farImpulse = Math.min(1, toImpulse + LONGER);
        for (int k = 0; k < heap.size(); k++) {
            double there = (impulse[k] + farImpulse * impulseStep[k]) * (speed[k] + farSpeed * speedStep[k]);
            product[k] = there < NEAR_GOAL * goal
                    ? NEAR_GOAL * goal - there
                    : Math.max(-goal / NEAR_GOAL, Math.min(0, goal / NEAR_GOAL - there));
            scratch[k] = product[k] / (speed[k] + YIELD * impulse[k]);
        }
        heap.spread(scratch, longerUStep);
        heap.solve(longerUStep);
        heap.separate(longerUStep, longerSpeedStep);
        for (int k = 0; k < heap.size(); k++) {
            double more = (product[k] - impulse[k] * longerSpeedStep[k]) / (speed[k] + YIELD * impulse[k]);
            longerImpulseStep[k] = impulseStep[k] + more;
            longerSpeedStep[k] += speedStep[k] + YIELD * more;
        }
        double longerSpeed = reach(heap, speed, longerSpeedStep);
        double longerImpulse = reach(heap, impulse, longerImpulseStep);
        if (longerSpeed + longerImpulse >= toSpeed + toImpulse + LEAST_LONGER) {
            toSpeed = longerSpeed;
            toImpulse = longerImpulse;
            System.arraycopy(longerImpulseStep, 0, impulseStep, 0, heap.size());
            System.arraycopy(longerSpeedStep, 0, speedStep, 0, heap.size());
            for (int i = 0; i < heap.unknowns(); i++) {
                uStep[i] += longerUStep[i];
            }
        }
    }
}

package io.github.apsis.engine.collision;

/**
 * Finds the impulses λ ≥ 0 of least ½ λ·Aλ + c·λ by conjugate gradients on the contacts that push, with projected steps where one
 * begins or ends to: MPRGP (Dostál 2009, "Optimal Quadratic Programming Algorithms", chapter 5).
 *
 * <p>Which contacts push is no more regular than a heap is, so no branch may ask: {@link #pushes} is 1 for those, 0 for others, and
 * multiplies: a round takes two thirds of the time.
 */
final class BoundedGradients {
    /** Of the gradient at contacts that push, against that at those which might begin to: Dostál's Γ. */
    private static final double PROPORTION = 1;

    /** Twice this is more than 1 for every number over 0. */
    private static final double HUGE = 0x1p600;

    /** A product may round to either side of what a quotient says. */
    private static final double SURELY = 1 - 0x1p-48;

    // All scaled as the matrix is.
    private final ContactMatrix matrix;
    double[] impulse = new double[16]; // λ
    double[] gradient = new double[16]; // w
    double[] lack = new double[16]; // c
    private double[] along = new double[16]; // the direction of a round
    private double[] change = new double[16]; // A · along
    private double[] pushes = new double[16]; // 1 where λ > 0, else 0
    private double[] missed = new double[16]; // speed by which a contact misses what it should have
    private double[] wrong = new double[16]; // square of the part of the gradient that may be followed

    // Of the present impulses.
    private double longest = 1; // step of steepest descent
    private double error; // the largest speed by which a contact misses what it should have
    private double pushing; // how wrong contacts are that push, and
    private double waiting; // those that should begin to

    BoundedGradients(ContactMatrix matrix) {
        this.matrix = matrix;
    }

    void reserve(int contacts) {
        if (contacts > impulse.length) {
            int capacity = Math.max(contacts, 2 * impulse.length);
            impulse = new double[capacity];
            gradient = new double[capacity];
            lack = new double[capacity];
            along = new double[capacity];
            change = new double[capacity];
            pushes = new double[capacity];
            missed = new double[capacity];
            wrong = new double[capacity];
        }
    }

    /** Adds to the gradient what the impulses make of it. */
    void multiplyIn() {
        matrix.multiply(impulse, change);
        for (int k = 0; k < matrix.size(); k++) {
            gradient[k] += change[k];
        }
    }

    /** c = w − A λ, and the most that a contact misses without impulses. */
    double separate() {
        matrix.multiply(impulse, lack);
        double most = 0;
        for (int k = 0; k < matrix.size(); k++) {
            lack[k] = gradient[k] - lack[k];
            most = Math.max(most, -lack[k] / matrix.scale(k));
        }
        return most;
    }

    /** The largest speed by which a contact misses what it should have. */
    double error() {
        return error;
    }

    /** Measures how far the impulses are from right. */
    void assess() {
        mark(matrix.size(), impulse, gradient, longest, pushes, missed, wrong);
        double worst = 0;
        double ofThosePushing = 0;
        double ofThoseWaiting = 0;
        for (int k = 0; k < matrix.size(); k++) {
            double share = pushes[k] * wrong[k];
            ofThosePushing += share;
            ofThoseWaiting += wrong[k] - share;
            double scale = matrix.scale(k);
            if (missed[k] > worst * scale * SURELY) { // seldom, so that the quotient is not in the way
                worst = Math.max(worst, missed[k] / scale);
            }
        }
        error = worst;
        pushing = ofThosePushing;
        waiting = ofThoseWaiting;
    }

    /** Loops over columns alone are methods of their own: so C2 makes vector code of them. */
    private static void mark(
            int n,
            double[] impulse,
            double[] gradient,
            double longest,
            double[] pushes,
            double[] missed,
            double[] wrong) {
        for (int k = 0; k < n; k++) {
            double w = gradient[k];
            double push = Math.min(1, impulse[k] * HUGE * HUGE);
            pushes[k] = push;
            missed[k] = Math.max(-w, push * w);
            wrong[k] = w * Math.min(impulse[k] / longest, w);
        }
    }

    /** Measures the impulses anew that somebody else has changed. */
    void measureAgain() {
        matrix.multiply(impulse, gradient);
        for (int k = 0; k < matrix.size(); k++) {
            gradient[k] += lack[k];
        }
        assess();
    }

    /** Looks at the matrix, before the first round. */
    void begin() {
        longest = 1.8 / matrix.norm();
        assess();
    }

    /**
     * Improves the impulses until they miss no more than is allowed.
     *
     * @return the number of rounds
     */
    int descend(double allowed, int mostRounds) {
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

    /** The next direction is the gradient of the contacts that push. */
    private void restart() {
        for (int k = 0; k < matrix.size(); k++) {
            along[k] = pushes[k] * gradient[k];
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
        double step = slope() / curvature;
        double feasible = feasible();
        if (step <= feasible) {
            move(step);
            turn(curvature);
        } else {
            expand(matrix.size(), feasible, longest, along, change, gradient, impulse);
            measureAgain();
            restart();
        }
        return true;
    }

    private double slope() {
        double slope = 0;
        for (int k = 0; k < matrix.size(); k++) {
            slope += gradient[k] * along[k];
        }
        return slope;
    }

    /** The longest step that turns no push to a pull. */
    private double feasible() {
        double feasible = Double.POSITIVE_INFINITY;
        for (int k = 0; k < matrix.size(); k++) {
            if (impulse[k] * SURELY <= feasible * along[k] && along[k] > 0) {
                feasible = Math.min(feasible, impulse[k] / along[k]);
            }
        }
        return feasible;
    }

    /** The next direction is conjugate to this one: φ − (φ · A p) / (p · A p) p. */
    private void turn(double curvature) {
        double sum = 0;
        for (int k = 0; k < matrix.size(); k++) {
            sum += pushes[k] * gradient[k] * change[k];
        }
        turn(matrix.size(), sum / curvature, pushes, gradient, along);
    }

    private static void turn(int n, double turn, double[] pushes, double[] gradient, double[] along) {
        for (int k = 0; k < n; k++) {
            along[k] = pushes[k] * (gradient[k] - turn * along[k]);
        }
    }

    /**
     * Goes as far as no push turns to a pull, and from there down the gradient, past the end of some. To take the whole step and
     * cut off what pulls is sooner exact, but in a heap that has to do with few rounds it leaves too many contacts without a push.
     */
    private static void expand(
            int n,
            double feasible,
            double longest,
            double[] along,
            double[] change,
            double[] gradient,
            double[] impulse) {
        for (int k = 0; k < n; k++) {
            double there = Math.max(0, impulse[k] - feasible * along[k]);
            double push = Math.min(1, there * HUGE * HUGE);
            impulse[k] = Math.max(0, push * (there - longest * (gradient[k] - feasible * change[k])));
        }
    }

    /** Lets those contacts begin to push that should. */
    private boolean release() {
        for (int k = 0; k < matrix.size(); k++) {
            along[k] = (1 - pushes[k]) * Math.min(0, gradient[k]);
        }
        double curvature = matrix.multiply(along, change);
        if (!(curvature > 0)) {
            return false;
        }
        move(slope() / curvature);
        restart();
        return true;
    }

    private void move(double step) {
        move(matrix.size(), step, along, change, impulse, gradient);
        assess();
    }

    private static void move(int n, double step, double[] along, double[] change, double[] impulse, double[] gradient) {
        for (int k = 0; k < n; k++) {
            impulse[k] = Math.max(0, impulse[k] - step * along[k]);
            gradient[k] -= step * change[k];
        }
    }
}

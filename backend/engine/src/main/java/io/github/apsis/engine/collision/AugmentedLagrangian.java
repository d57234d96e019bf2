package io.github.apsis.engine.collision;

/**
 * Improves the impulses of a heap that are nearly right to as good as numbers allow, also where contacts hold each other so that
 * their impulses are not unique. With stiffness σ, the velocities u of
 *
 * <pre>
 *   u = Gᵀ max(0, λ − σ (c + G u))
 * </pre>
 *
 * <p>give better impulses λ ← max(0, λ − σ (c + G u)), and so on (the method of multipliers: Hestenes 1969, J. Optim. Theory Appl. 4,
 * 303). The velocities are found by Newton's method, for which the contacts that push are to be known; in a heap at rest they are,
 * and it takes a single factor, or one of some ticks ago.
 */
final class AugmentedLagrangian {

    /** An improvement that leaves more than this of the error is the last. */
    private static final double WORTH = 0.5;

    /** Of the slope at the start of a step: one that leaves less at its end is taken whole. */
    private static final double GENTLE = 0.1;

    private static final int HALVINGS = 40;

    /** With an old factor; more steps cost as much as a new one. */
    private static final int MOST_STEPS = 4;

    /** A step is found to this share of the allowed error. */
    private static final double EXACTLY = 0.25;

    private final PreconditionedGradients system = new PreconditionedGradients();
    private double stiffness;
    private double[] impulse = new double[0];
    private double[] lack = new double[0];
    private double[] speed = new double[0]; // c + G u
    private double[] speedStep = new double[0];
    private double[] push = new double[0]; // max(0, λ − σ speed)
    private double[] weight = new double[0]; // σ where that is positive
    private double[] u = new double[0];
    private double[] step = new double[0];

    /**
     * Improves impulses.
     *
     * @param lack c, scaled as the matrix
     * @param stiffness σ: an improvement takes all of the error but the share 1 / (1 + σ times the smallest eigenvalue of A), but
     *     Newton's method comes from less far, and rounding grows with σ
     * @param allowed the error at which it ends
     * @param mostFactors after which it ends too
     * @param found the impulses; they change only for better ones
     * @return the largest speed by which a contact misses what it should have
     */
    double improve(HeapMatrix heap, double[] lack, double stiffness, double allowed, int mostFactors, double[] found) {
        double best = error(heap, lack, found);
        this.stiffness = stiffness;
        double before = best;
        boolean factored = false;
        int factors = 0;
        while (best > allowed) {
            if (push(heap.size()) || !factored) {
                if (factors++ == mostFactors) {
                    break;
                }
                heap.factor(weight);
                factored = true;
            }
            aim(heap);
            heap.solve(step);
            advance(heap);
            if (pushersChanged(heap.size())) {
                continue;
            }
            double error = take(heap);
            best = keep(heap.size(), error, best, found);
            if (!(error < WORTH * before)) {
                break;
            }
            before = error;
        }
        return best;
    }

    /** Improves impulses with the factor that the heap has, which was made for such a stiffness, as long as it is near. */
    double follow(HeapMatrix heap, double[] lack, double stiffness, double allowed, double[] found) {
        double best = error(heap, lack, found);
        this.stiffness = stiffness;
        for (int i = 0; i < MOST_STEPS && best > allowed; i++) {
            push(heap.size());
            aim(heap);
            if (!system.solve(heap, weight, EXACTLY * allowed, step)) {
                break;
            }
            advance(heap);
            if (!pushersChanged(heap.size())) {
                best = keep(heap.size(), take(heap), best, found);
            }
        }
        return best;
    }

    /** Takes the pushes for the impulses; what they miss is returned. */
    private double take(HeapMatrix heap) {
        push(heap.size());
        System.arraycopy(push, 0, impulse, 0, heap.size());
        return error(heap);
    }

    private double keep(int n, double error, double best, double[] found) {
        if (error < best) {
            System.arraycopy(impulse, 0, found, 0, n);
        }
        return Math.min(error, best);
    }

    /** The largest speed by which a contact misses what it should have. */
    double error(HeapMatrix heap, double[] lack, double[] impulses) {
        reserve(heap);
        this.lack = lack;
        System.arraycopy(impulses, 0, impulse, 0, heap.size());
        return error(heap);
    }

    private void reserve(HeapMatrix heap) {
        if (heap.size() > impulse.length) {
            int capacity = Math.max(heap.size(), 2 * impulse.length);
            impulse = new double[capacity];
            speed = new double[capacity];
            speedStep = new double[capacity];
            push = new double[capacity];
            weight = new double[capacity];
        }
        if (heap.unknowns() > u.length) {
            int capacity = Math.max(heap.unknowns(), 2 * u.length);
            u = new double[capacity];
            step = new double[capacity];
        }
    }

    /** Sets the velocities to what the impulses give, and measures by how much a contact misses what it should have. */
    private double error(HeapMatrix heap) {
        heap.spread(impulse, u);
        heap.separate(u, speed);
        double error = 0;
        for (int k = 0; k < heap.size(); k++) {
            speed[k] += lack[k];
            error = Math.max(error, impulse[k] > 0 ? Math.abs(speed[k]) : -speed[k]);
        }
        return error;
    }

    /** Sets pushes and weights; returns whether other contacts push than the weights said. */
    private boolean push(int n) {
        boolean changed = false;
        for (int k = 0; k < n; k++) {
            push[k] = Math.max(0, impulse[k] - stiffness * speed[k]);
            double now = push[k] > 0 ? stiffness : 0;
            changed |= now != weight[k];
            weight[k] = now;
        }
        return changed;
    }

    private boolean pushersChanged(int n) {
        for (int k = 0; k < n; k++) {
            if (impulse[k] - stiffness * speed[k] > 0 != weight[k] > 0) {
                return true;
            }
        }
        return false;
    }

    /** The right side of a step of Newton's. */
    private void aim(HeapMatrix heap) {
        heap.spread(push, step);
        for (int i = 0; i < heap.unknowns(); i++) {
            step[i] -= u[i];
        }
    }

    /** Takes the step, as long as it leads down: ½ |u|² + ½ |push|² / σ is least where the velocities are right. */
    private void advance(HeapMatrix heap) {
        heap.separate(step, speedStep);
        double along = 0;
        double square = 0;
        for (int i = 0; i < heap.unknowns(); i++) {
            along += u[i] * step[i];
            square += step[i] * step[i];
        }
        double part = part(heap.size(), along, square);
        for (int i = 0; i < heap.unknowns(); i++) {
            u[i] += part * step[i];
        }
        for (int k = 0; k < heap.size(); k++) {
            speed[k] += part * speedStep[k];
        }
    }

    private double part(int n, double along, double square) {
        double end = slope(n, 1, along, square);
        if (end <= 0 || end <= -GENTLE * slope(n, 0, along, square)) {
            return 1;
        }
        double down = 0;
        double up = 1;
        for (int i = 0; i < HALVINGS; i++) {
            double middle = 0.5 * (down + up);
            if (slope(n, middle, along, square) > 0) {
                up = middle;
            } else {
                down = middle;
            }
        }
        return down;
    }

    private double slope(int n, double part, double along, double square) {
        double slope = along + part * square;
        for (int k = 0; k < n; k++) {
            slope -= speedStep[k] * Math.max(0, impulse[k] - stiffness * (speed[k] + part * speedStep[k]));
        }
        return slope;
    }
}

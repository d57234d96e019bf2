package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;

/**
 * The impulses in a heap of hundreds of bodies, directly: a heap without friction is all but floppy, and what conjugate gradients
 * leave of it after as many rounds as a tick affords would keep it from ever coming to rest.
 *
 * <p>Where the impulses of the last tick are nearly right, {@link AugmentedLagrangian} has them right with the factor of a tick before,
 * a new one or a few; if they are not, {@link InteriorPoint} finds them from nothing.
 */
final class HeapSolver {
    /** Newton's method comes from farther with the first of them, and impulses are right to the last digits with the last. */
    private static final double SOFTEST = 1e3;

    private static final double STIFFEST = 1e7;

    private static final double STIFFER = 10;

    /** If a new factor does not do with so many, other contacts push than did. */
    private static final int FEW_FACTORS = 3;

    /** After so many factors without success another stiffness may have it. */
    private static final int MOST_FACTORS = 8;

    /** Impulses that miss by more than this share of the most that a contact lacks are sooner found from nothing. */
    private static final double NEAR = 1e-2;

    /** So near three factors may do; farther off they hardly ever do. */
    private static final double NEARER = 1e-4;

    private final HeapMatrix heap = new HeapMatrix();
    private final AugmentedLagrangian lagrangian = new AugmentedLagrangian();
    private final InteriorPoint interiorPoint = new InteriorPoint();
    private final double stiffness;

    /**
     * Creates a solver that has no factor yet.
     *
     * @param stiffness of the factor that is kept from tick to tick: a contact that misses its speed changes its impulse by as much
     *     times that, so it should be about the ratio of impulses to what they usually miss
     */
    HeapSolver(double stiffness) {
        this.stiffness = stiffness;
    }

    /**
     * Improves impulses as far as it can. It goes fast when it has solved the same heap, a little while ago, before.
     *
     * @param lack c, scaled as the matrix
     * @param most −c of the contact that lacks most, over 0
     * @param allowed the speed by which a contact may miss what it should have
     * @param impulse scaled as the matrix
     */
    void improve(ContactMatrix matrix, Bodies bodies, double[] lack, double most, double allowed, double[] impulse) {
        double enough = ImpulseSolver.GOOD_ENOUGH * allowed;
        double near = NEAR * most;
        heap.set(matrix, bodies);
        double error = lagrangian.error(heap, lack, impulse);
        if (heap.isFactored()) {
            if (error <= near) {
                error = lagrangian.follow(heap, lack, stiffness, allowed, impulse);
            }
            if (error > enough) {
                heap.forget();
                heap.set(matrix, bodies);
            }
        }
        if (error > enough && error <= NEARER * most) {
            error = lagrangian.improve(heap, lack, stiffness, allowed, FEW_FACTORS, impulse);
        }
        if (error > enough) {
            if (error <= near) {
                error = refine(lack, error, allowed, impulse);
            }
            if (error > enough && interiorPoint.solve(heap, lack, most, allowed, impulse)) {
                refine(lack, lagrangian.error(heap, lack, impulse), allowed, impulse);
            }
            heap.forget(); // it is of another stiffness
        }
    }

    /** Solves the next heap as if it were the first. */
    void forget() {
        heap.forget();
    }

    /** Tries one stiffness after the other; where one has improved nothing, none that is stiffer ever did. */
    private double refine(double[] lack, double before, double allowed, double[] impulse) {
        double error = before;
        boolean improves = true;
        for (double next = SOFTEST;
                improves && next <= STIFFEST && error > ImpulseSolver.GOOD_ENOUGH * allowed;
                next *= STIFFER) {
            double improved = lagrangian.improve(heap, lack, next, allowed, MOST_FACTORS, impulse);
            improves = improved < error;
            error = improved;
        }
        return error;
    }
}

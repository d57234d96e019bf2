package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;

/**
 * The impulses in a heap of hundreds of bodies, directly: a heap without friction is all but floppy, and what conjugate gradients
 * leave of it after as many rounds as a tick affords would keep it from ever coming to rest.
 *
 * <p>Where the impulses of the last tick are nearly right, {@link AugmentedLagrangian} has them right with one factor or a few; if
 * they are not, {@link InteriorPoint} finds them from nothing.
 */
final class HeapSolver {
    /** Newton's method comes from farther with the first of them, and impulses are right to the last digits with the last. */
    private static final double SOFTEST = 1e3;

    private static final double STIFFEST = 1e7;

    private static final double STIFFER = 10;

    /** After so many factors without success another stiffness may have it. */
    private static final int MOST_FACTORS = 8;

    /** Impulses that miss by more than this share of the most that a contact lacks are sooner found from nothing. */
    private static final double NEAR = 1e-2;

    private final HeapMatrix heap = new HeapMatrix();
    private final AugmentedLagrangian lagrangian = new AugmentedLagrangian();
    private final InteriorPoint interiorPoint = new InteriorPoint();

    /**
     * Improves impulses as far as it can.
     *
     * @param lack c, scaled as the matrix
     * @param most −c of the contact that lacks most, over 0
     * @param allowed the speed by which a contact may miss what it should have
     * @param impulse scaled as the matrix
     */
    void improve(ContactMatrix matrix, Bodies bodies, double[] lack, double most, double allowed, double[] impulse) {
        heap.set(matrix, bodies);
        double error = lagrangian.error(heap, lack, impulse);
        if (error <= NEAR * most) {
            error = refine(lack, error, allowed, impulse);
        }
        if (error > ImpulseSolver.GOOD_ENOUGH * allowed && interiorPoint.solve(heap, lack, most, impulse)) {
            refine(lack, lagrangian.error(heap, lack, impulse), allowed, impulse);
        }
    }

    private double refine(double[] lack, double before, double allowed, double[] impulse) {
        double error = before;
        for (double stiffness = SOFTEST;
                stiffness <= STIFFEST && error > ImpulseSolver.GOOD_ENOUGH * allowed;
                stiffness *= STIFFER) {
            error = lagrangian.improve(heap, lack, stiffness, allowed, MOST_FACTORS, impulse);
        }
        return error;
    }
}

package io.github.apsis.engine.math;

/**
 * A sum that keeps the rounding error of every addition (Neumaier 1974, ZAMM 54, 39): its error does not grow with the
 * number of terms.
 */
public final class CompensatedSum {
    private double sum;
    private double compensation;

    public void add(double term) {
        double next = sum + term;
        // The smaller of the two lost its low bits in the addition.
        compensation += Math.abs(sum) >= Math.abs(term) ? (sum - next) + term : (term - next) + sum;
        sum = next;
    }

    /** Begins anew. */
    public void clear() {
        sum = 0;
        compensation = 0;
    }

    /** The sum; infinite where it left the range of doubles. */
    public double value() {
        double value = sum + compensation;
        return Double.isNaN(value) ? sum : value; // no error is left to correct in an infinite sum
    }
}

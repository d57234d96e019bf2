package io.github.apsis.engine.integration;

/** A sum carried in two doubles, the second below the last bit of the first (Dekker 1971, Numer. Math. 18, 224). */
final class TwoDoubles {
    private double high;
    private double low;

    double high() {
        return high;
    }

    double low() {
        return low;
    }

    /** start + t · first + t² · second + rest, the products exactly. */
    void set(double start, double t, double first, double t2, double second, double rest) {
        double p = t * first;
        double q = t2 * second;
        double products = Math.fma(t, first, -p) + Math.fma(t2, second, -q) + Math.fma(t, t, -t2) * second;
        double a = start + p;
        double b = a + q;
        double lost = lost(start, p, a) + lost(a, q, b) + products;
        double c = b + rest;
        lost += lost(b, rest, c);
        high = c + lost;
        low = lost - (high - c);
    }

    /** What a + b has lost when it was rounded to sum (Knuth's two-sum). */
    static double lost(double a, double b, double sum) {
        double taken = sum - a;
        return (a - (sum - taken)) + (b - taken);
    }
}

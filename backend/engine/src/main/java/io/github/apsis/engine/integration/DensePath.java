package io.github.apsis.engine.integration;

/**
 * The path of one body, or of one seen from another, through a {@link TaylorStep}: a polynomial in time that can be asked for
 * any moment of the step. Refilled for every path that somebody looks at.
 */
public final class DensePath {
    private final double[] x;
    private final double[] y;
    private final int order;
    private double unit; // of time, in which the coefficients are

    private double px;
    private double py;
    private double vx;
    private double vy;
    private double hx; // half the acceleration
    private double hy;

    DensePath(int order) {
        this.order = order;
        this.x = new double[order + 1];
        this.y = new double[order + 1];
    }

    void begin(double timeUnit) {
        unit = timeUnit;
    }

    void set(int k, double coefficientX, double coefficientY) {
        x[k] = coefficientX;
        y[k] = coefficientY;
    }

    /** Looks at a time after the beginning of the step: place, velocity and acceleration are those of then (Horner's scheme). */
    public void lookAt(double time) {
        double t = time / unit;
        clear();
        for (int k = order; k >= 0; k--) {
            hx = hx * t + vx;
            hy = hy * t + vy;
            vx = vx * t + px;
            vy = vy * t + py;
            px = px * t + x[k];
            py = py * t + y[k];
        }
    }

    private void clear() {
        px = 0;
        py = 0;
        vx = 0;
        vy = 0;
        hx = 0;
        hy = 0;
    }

    /** No acceleration until this time is larger: Σ k (k − 1) |r[k]| t^(k−2). */
    public double mostAcceleration(double time) {
        double t = time / unit;
        double bound = 0;
        for (int k = order; k >= 2; k--) {
            bound = bound * t + k * (k - 1) * Math.sqrt(x[k] * x[k] + y[k] * y[k]);
        }
        return bound / (unit * unit);
    }

    public double x() {
        return px;
    }

    public double y() {
        return py;
    }

    public double vx() {
        return vx / unit;
    }

    public double vy() {
        return vy / unit;
    }

    public double ax() {
        return 2 * hx / (unit * unit);
    }

    public double ay() {
        return 2 * hy / (unit * unit);
    }
}

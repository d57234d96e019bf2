package io.github.apsis.engine.steering;

/** A vector that behaviours fill in and the next ship reuses: a decision allocates nothing. */
public final class SteeringVector {
    double x;
    double y;

    public double x() {
        return x;
    }

    public double y() {
        return y;
    }

    public void set(double newX, double newY) {
        x = newX;
        y = newY;
    }

    void add(double dx, double dy) {
        x += dx;
        y += dy;
    }

    /** Shortens the vector to this length if it is longer. */
    void limit(double length) {
        double is = length();
        if (is > length) {
            x *= length / is;
            y *= length / is;
        }
    }

    double length() {
        return Math.sqrt(x * x + y * y);
    }
}

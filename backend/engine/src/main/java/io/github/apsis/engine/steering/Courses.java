package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;

/** The courses of all ships at the start of a decision, by slot: what they look at while they write new ones. */
final class Courses {
    private double[] x = new double[0];
    private double[] y = new double[0];
    private boolean[] evading = new boolean[0];

    void copy(Bodies bodies) {
        if (x.length < bodies.count()) {
            int capacity = bodies.count() + bodies.count() / 2 + 16;
            x = new double[capacity];
            y = new double[capacity];
            evading = new boolean[capacity];
        }
        for (int i : bodies.ships()) {
            x[i] = bodies.courseX(i);
            y[i] = bodies.courseY(i);
            evading[i] = bodies.isEvading(i);
        }
    }

    double x(int i) {
        return x[i];
    }

    double y(int i) {
        return y[i];
    }

    boolean isEvading(int i) {
        return evading[i];
    }
}

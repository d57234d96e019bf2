package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;

/** The courses of all ships at the start of a decision: what they look at while they write new ones. */
final class Courses {
    private Bodies bodies = new Bodies(); // whose they are

    // By the number of a ship; the first stands for all that is no ship.
    private double[] x = new double[1];
    private double[] y = new double[1];
    private boolean[] evading = new boolean[1];

    void copy(Bodies of) {
        bodies = of;
        int[] ships = of.ships();
        if (x.length <= ships.length) {
            int capacity = ships.length + ships.length / 8 + 16;
            x = new double[capacity];
            y = new double[capacity];
            evading = new boolean[capacity];
        }
        for (int i : ships) {
            int ship = of.shipNumber(i);
            x[ship] = of.courseX(i);
            y[ship] = of.courseY(i);
            evading[ship] = of.isEvading(i);
        }
    }

    double x(int i) {
        return x[bodies.shipNumber(i)];
    }

    double y(int i) {
        return y[bodies.shipNumber(i)];
    }

    boolean isEvading(int i) {
        return evading[bodies.shipNumber(i)];
    }
}

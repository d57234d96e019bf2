package io.github.apsis.scenes.shape;

import java.util.Arrays;

/**
 * The drawn shape of an asteroid: convex, counter-clockwise, about the centre of its minimum enclosing circle, at angle 0.
 * The physics knows only the circle.
 */
public final class Outline {
    private final double[] xy;

    public Outline(double[] xy) {
        this.xy = xy.clone();
    }

    public int count() {
        return xy.length / 2;
    }

    public double x(int vertex) {
        return xy[2 * vertex];
    }

    public double y(int vertex) {
        return xy[2 * vertex + 1];
    }

    @Override
    public String toString() {
        return Arrays.toString(xy);
    }
}

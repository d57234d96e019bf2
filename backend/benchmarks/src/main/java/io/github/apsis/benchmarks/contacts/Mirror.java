package io.github.apsis.benchmarks.contacts;

import io.github.apsis.engine.WorldSnapshot;

/**
 * Whether bodies are mirror images of each other, left and right or above and below, about the middle of their extent. A row
 * is its own image about its own line, which proves nothing: a mirror counts only where it maps a body to another.
 */
final class Mirror {
    private final WorldSnapshot state;
    private final boolean upright;
    private final double tolerance;
    private final double middle;

    private Mirror(WorldSnapshot state, boolean upright, double tolerance) {
        this.state = state;
        this.upright = upright;
        this.tolerance = tolerance;
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < state.count(); i++) {
            least = Math.min(least, across(i));
            most = Math.max(most, across(i));
        }
        this.middle = (least + most) / 2;
    }

    /** Whether what was symmetric at the start is so at the end, within a tolerance of velocity; false where nothing was. */
    static boolean isKept(WorldSnapshot start, WorldSnapshot end, double tolerance) {
        boolean any = false;
        for (boolean upright : new boolean[] {true, false}) {
            if (new Mirror(start, upright, 0).isSymmetric()) {
                any = true;
                if (!new Mirror(end, upright, tolerance).isSymmetric()) {
                    return false;
                }
            }
        }
        return any;
    }

    private boolean isSymmetric() {
        boolean moves = false;
        for (int i = 0; i < state.count(); i++) {
            int image = imageOf(i);
            if (image < 0) {
                return false;
            }
            moves |= image != i;
        }
        return moves;
    }

    private int imageOf(int i) {
        for (int j = 0; j < state.count(); j++) {
            if (state.mass(i) == state.mass(j) && state.radius(i) == state.radius(j) && mirrors(i, j)) {
                return j;
            }
        }
        return -1;
    }

    private boolean mirrors(int i, int j) {
        double size = state.radius(i) * 1e-6; // places only tell which is whose image
        return Math.abs(across(i) + across(j) - 2 * middle) <= size
                && Math.abs(along(i) - along(j)) <= size
                && Math.abs(velocityAcross(i) + velocityAcross(j)) <= tolerance
                && Math.abs(velocityAlong(i) - velocityAlong(j)) <= tolerance;
    }

    private double across(int i) {
        return upright ? state.x(i) : state.y(i);
    }

    private double along(int i) {
        return upright ? state.y(i) : state.x(i);
    }

    private double velocityAcross(int i) {
        return upright ? state.vx(i) : state.vy(i);
    }

    private double velocityAlong(int i) {
        return upright ? state.vy(i) : state.vx(i);
    }
}

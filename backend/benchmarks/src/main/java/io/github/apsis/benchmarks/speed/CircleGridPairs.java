package io.github.apsis.benchmarks.speed;

import io.github.apsis.engine.spatial.CircleGrid;

/** By the grids that the contacts of a world use: made anew, and all pairs at once. */
final class CircleGridPairs implements PairFinder {
    private final CircleGrid grid = new CircleGrid(null);

    @Override
    public void find(Circles circles, Pairs pairs) {
        grid.begin(circles.count());
        for (int i = 0; i < circles.count(); i++) {
            grid.set(i, circles.x()[i], circles.y()[i], circles.r()[i]);
        }
        grid.build();
        int found = grid.findPairs();
        for (int k = 0; k < found; k++) {
            if (circles.overlap(grid.first(k), grid.second(k))) { // it gives what is a rounding apart as well
                pairs.add(grid.first(k), grid.second(k));
            }
        }
    }
}

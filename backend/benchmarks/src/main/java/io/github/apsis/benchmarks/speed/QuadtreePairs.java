package io.github.apsis.benchmarks.speed;

import io.github.apsis.engine.spatial.Quadtree;

/** By the engine's quadtree: built over all boxes and asked for the neighbours of each. */
final class QuadtreePairs implements PairFinder {
    private final Quadtree tree = new Quadtree();

    @Override
    public void find(Circles circles, Pairs pairs) {
        double[] x = circles.x();
        double[] y = circles.y();
        double[] r = circles.r();
        tree.begin(r.length);
        for (int i = 0; i < r.length; i++) {
            tree.set(i, x[i] - r[i], y[i] - r[i], x[i] + r[i], y[i] + r[i]);
        }
        tree.build();
        for (int i = 0; i < r.length; i++) {
            int hits = tree.query(x[i] - r[i], y[i] - r[i], x[i] + r[i], y[i] + r[i]);
            for (int hit = 0; hit < hits; hit++) {
                int j = tree.found(hit);
                if (j > i && circles.overlap(i, j)) {
                    pairs.add(i, j);
                }
            }
        }
    }
}

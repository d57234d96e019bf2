package io.github.apsis.benchmarks.speed;

import java.util.List;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.index.quadtree.Quadtree;

/** By the quadtree of JTS: filled with all boxes and asked for the neighbours of each. */
final class JtsPairs implements PairFinder {
    @Override
    public void find(Circles circles, Pairs pairs) {
        Quadtree tree = new Quadtree();
        for (int i = 0; i < circles.count(); i++) {
            tree.insert(box(circles, i), i);
        }
        for (int i = 0; i < circles.count(); i++) {
            List<?> near = tree.query(box(circles, i));
            for (Object item : near) {
                int j = (Integer) item;
                if (j > i && circles.overlap(i, j)) {
                    pairs.add(i, j);
                }
            }
        }
    }

    private static Envelope box(Circles circles, int i) {
        double r = circles.r()[i];
        return new Envelope(circles.x()[i] - r, circles.x()[i] + r, circles.y()[i] - r, circles.y()[i] + r);
    }
}

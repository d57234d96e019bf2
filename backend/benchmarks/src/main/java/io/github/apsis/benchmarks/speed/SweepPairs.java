package io.github.apsis.benchmarks.speed;

import java.util.Comparator;
import java.util.stream.IntStream;

/** By a sweep along x, which shares nothing with a tree or a grid: says what is true. */
final class SweepPairs implements PairFinder {
    @Override
    public void find(Circles circles, Pairs pairs) {
        double[] x = circles.x();
        double[] r = circles.r();
        int[] order = IntStream.range(0, circles.count())
                .boxed()
                .sorted(Comparator.comparingDouble(i -> x[i] - r[i]))
                .mapToInt(Integer::intValue)
                .toArray();
        for (int a = 0; a < order.length; a++) {
            int i = order[a];
            for (int b = a + 1; b < order.length && x[order[b]] - r[order[b]] < x[i] + r[i]; b++) {
                if (circles.overlap(i, order[b])) {
                    pairs.add(i, order[b]);
                }
            }
        }
    }
}

package io.github.apsis.benchmarks.speed;

/** Finds all pairs of circles that overlap, from scratch. */
interface PairFinder {
    void find(Circles circles, Pairs pairs);
}

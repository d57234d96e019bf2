package io.github.apsis.benchmarks.speed;

/**
 * An error that a run had.
 *
 * @param kind names the measure, for example {@code energy-drift}
 */
record Finding(String kind, double value) {}

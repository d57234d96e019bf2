package io.github.apsis.engine.math;

/**
 * Seeded random numbers: SplitMix64 (Steele, Lea and Flood 2014, OOPSLA, "Fast splittable pseudorandom number generators").
 * The same seed gives the same numbers on every machine.
 */
public final class Rng {
    private static final long GOLDEN_GAMMA = 0x9E3779B97F4A7C15L;

    private long state;

    public Rng(long seed) {
        this.state = seed;
    }

    /** The next 64 random bits. */
    public long nextLong() {
        state += GOLDEN_GAMMA;
        return mix(state);
    }

    /** Uniform in [0, 1), with 53 random bits. */
    public double nextDouble() {
        return toUnit(nextLong());
    }

    /** Uniform in [from, to). */
    public double between(double from, double to) {
        return from + (to - from) * nextDouble();
    }

    /** Uniform in 0 … bound − 1. */
    public int nextInt(int bound) {
        if (bound <= 0) {
            throw new IllegalArgumentException("bound must be positive, was " + bound);
        }
        return (int) (nextDouble() * bound);
    }

    /** Uniform in [0, 1) by counter: a pure function of its arguments, so no order of calls can change it. */
    public static double unitAt(long seed, long stream, long counter) {
        return toUnit(mix(mix(mix(seed + GOLDEN_GAMMA) + stream * GOLDEN_GAMMA) + counter * GOLDEN_GAMMA));
    }

    private static double toUnit(long bits) {
        return (bits >>> 11) * 0x1.0p-53;
    }

    private static long mix(long bits) {
        long z = bits;
        z = (z ^ (z >>> 30)) * 0xBF58476D1CE4E5B9L;
        z = (z ^ (z >>> 27)) * 0x94D049BB133111EBL;
        return z ^ (z >>> 31);
    }
}

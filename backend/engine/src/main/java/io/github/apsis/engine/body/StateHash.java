package io.github.apsis.engine.body;

/** The 64-bit FNV-1a hash (Fowler, Noll and Vo 1991), of numbers instead of bytes. */
final class StateHash {
    static final long EMPTY = 0xcbf29ce484222325L;
    private static final long PRIME = 0x100000001b3L;

    private StateHash() {}

    static long fold(long hash, long bits) {
        long h = hash;
        for (int shift = 0; shift < 64; shift += 8) {
            h = (h ^ ((bits >>> shift) & 0xff)) * PRIME;
        }
        return h;
    }

    static long fold(long hash, double number) {
        return fold(hash, Double.doubleToLongBits(number + 0.0)); // −0 and 0 are one state
    }
}

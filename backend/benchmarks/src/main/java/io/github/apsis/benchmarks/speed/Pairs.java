package io.github.apsis.benchmarks.speed;

/** What a finder of pairs has found: how many, and a sum over them that depends on no order. */
final class Pairs {
    private int count;
    private long checksum;

    void clear() {
        count = 0;
        checksum = 0;
    }

    void add(int i, int j) {
        count++;
        checksum += Math.min(i, j) * 1_000_003L + Math.max(i, j);
    }

    int count() {
        return count;
    }

    /** 0 where these are the true pairs; else how many too many or too few, at least one, as a share of the true ones. */
    double wrong(Pairs truth) {
        if (count == truth.count && checksum == truth.checksum) {
            return 0;
        }
        return Math.max(1.0, Math.abs(count - truth.count)) / Math.max(1, truth.count);
    }
}

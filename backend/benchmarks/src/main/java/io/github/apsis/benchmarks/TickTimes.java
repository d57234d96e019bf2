package io.github.apsis.benchmarks;

/**
 * The durations of many ticks, as a histogram: 64 buckets to each power of two, so a percentile is at most 1.6 % too high.
 * The maximum is exact. Takes the same memory for any number of ticks, and recording allocates nothing.
 */
public final class TickTimes {
    private static final int SUB_BITS = 6;
    private static final int SUB_BUCKETS = 1 << SUB_BITS;

    private final long[] counts = new long[(64 - SUB_BITS) * SUB_BUCKETS];
    private long count;
    private long totalNanos;
    private long maxNanos;

    /** Adds one tick. A clock that stepped back counts as 0. */
    public void record(long nanos) {
        long duration = Math.max(0, nanos);
        counts[bucket(duration)]++;
        count++;
        totalNanos += duration;
        maxNanos = Math.max(maxNanos, duration);
    }

    public long count() {
        return count;
    }

    public long totalNanos() {
        return totalNanos;
    }

    public long maxNanos() {
        return maxNanos;
    }

    /** The duration that this share of the ticks, 0 to 1, did not exceed; 0 without ticks. */
    public long percentileNanos(double share) {
        long rank = (long) Math.ceil(share * count);
        long seen = 0;
        for (int i = 0; i < counts.length; i++) {
            seen += counts[i];
            if (seen >= rank && seen > 0) {
                return Math.min(maxNanos, upperEdge(i));
            }
        }
        return 0;
    }

    /** Values below 64 have a bucket each; above, the six bits behind the leading one choose it. */
    private static int bucket(long nanos) {
        if (nanos < SUB_BUCKETS) {
            return (int) nanos;
        }
        int octave = 63 - Long.numberOfLeadingZeros(nanos) - SUB_BITS;
        return (octave << SUB_BITS) + (int) (nanos >>> octave);
    }

    private static long upperEdge(int bucket) {
        if (bucket < SUB_BUCKETS) {
            return bucket;
        }
        int octave = (bucket >>> SUB_BITS) - 1;
        long leading = bucket - ((long) octave << SUB_BITS);
        return ((leading + 1) << octave) - 1;
    }
}

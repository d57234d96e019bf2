package io.github.apsis.benchmarks;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;

/** CPU time of this thread: what others do on the machine at the same time counts less than on a wall clock. */
public final class CpuTime {
    private static final long SHORT_NANOS = 20_000_000; // below this a measurement repeats what it measures
    private static final long WARM_NANOS = 20_000_000; // the compiler knows the method already: see the study
    private static final long PATIENCE_NANOS = 2_000_000_000;
    private static final int RUNS = 3;
    private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();

    private CpuTime() {}

    /** Best of three after a short while to warm up, fewer when a run takes seconds. */
    public static double bestMicros(Runnable work) {
        long once = warmUp(work, WARM_NANOS);
        int times = (int) (1 + SHORT_NANOS / Math.max(1, once));
        long best = Long.MAX_VALUE;
        long spent = 0;
        for (int run = 0; run < RUNS && spent < PATIENCE_NANOS; run++) {
            long taken = nanos(work, times);
            spent += taken;
            best = Math.min(best, taken);
        }
        return best * 1e-3 / times;
    }

    /** Runs at least that long, and returns what the last run took, ns. */
    public static long warmUp(Runnable work, long nanos) {
        long spent = 0;
        long last = 0;
        while (spent < nanos) {
            last = nanos(work, 1);
            spent += Math.max(1000, last);
        }
        return last;
    }

    /** Median of up to thirty, at least three, after half a second to warm up. */
    public static double medianMicros(Runnable work) {
        warmUp(work, PATIENCE_NANOS / 4);
        double[] micros = new double[30];
        int runs = 0;
        long spent = 0;
        while (runs < RUNS || (runs < micros.length && spent < PATIENCE_NANOS)) {
            long taken = nanos(work, 1);
            spent += taken;
            micros[runs++] = taken * 1e-3;
        }
        Arrays.sort(micros, 0, runs);
        return micros[runs / 2];
    }

    /** What one run takes, ns. */
    public static long nanosOnce(Runnable work) {
        return nanos(work, 1);
    }

    private static long nanos(Runnable work, int times) {
        long before = THREADS.getCurrentThreadCpuTime();
        for (int i = 0; i < times; i++) {
            work.run();
        }
        return THREADS.getCurrentThreadCpuTime() - before;
    }
}

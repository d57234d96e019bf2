package io.github.apsis.benchmarks.speed;

import com.sun.management.ThreadMXBean;
import io.github.apsis.benchmarks.TickTimes;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;

/**
 * Measures steps in batches: CPU time and allocated bytes of the thread for each batch as a whole, the clock for each step. CPU
 * time does not count what others do on the machine meanwhile; of the batches the median counts, so that an interrupt
 * or a late compilation spoils one of them and not the figure. Of the bytes those of the second half count, together.
 */
final class StepMeter {
    private static final ThreadMXBean THREAD = (ThreadMXBean) ManagementFactory.getThreadMXBean();

    static {
        new StepMeter(1).batch(() -> {}, 1); // the first batch of a JVM allocates 584 bytes, whatever it measures
    }

    private final int threads;
    private final TickTimes clock = new TickTimes();
    private final List<Double> nanosPerStep = new ArrayList<>();
    private final List<Integer> steps = new ArrayList<>(); // by batch
    private final List<Long> bytes = new ArrayList<>();
    private long cpuNanos;

    /** With one thread the CPU time of this thread is the cost; with more it is what the clock says. */
    StepMeter(int threads) {
        this.threads = threads;
    }

    void batch(Runnable step, int count) {
        long clockBefore = clock.totalNanos();
        long bytesBefore = THREAD.getCurrentThreadAllocatedBytes();
        long cpuBefore = THREAD.getCurrentThreadCpuTime();
        for (int i = 0; i < count; i++) {
            long before = System.nanoTime();
            step.run();
            clock.record(System.nanoTime() - before);
        }
        long cpu = THREAD.getCurrentThreadCpuTime() - cpuBefore;
        bytes.add(THREAD.getCurrentThreadAllocatedBytes() - bytesBefore);
        cpuNanos += cpu;
        steps.add(count);
        nanosPerStep.add((double) (threads == 1 ? cpu : clock.totalNanos() - clockBefore) / count);
    }

    /** CPU time so far, ns. */
    long cpuNanos() {
        return cpuNanos;
    }

    /** Of all batches. */
    StepCost cost() {
        double median = nanosPerStep.stream()
                .sorted()
                .skip(nanosPerStep.size() / 2)
                .findFirst()
                .orElse(Double.NaN);
        return new StepCost(median * 1e-6, clock.percentileNanos(0.99) * 1e-6, bytesPerStep());
    }

    /** In the second half of all batches: columns are as long by then as a scene needs them, which is what a leak never is. */
    private double bytesPerStep() {
        int half = steps.size() / 2;
        long allocated = bytes.stream().skip(half).mapToLong(Long::longValue).sum();
        return (double) allocated
                / steps.stream().skip(half).mapToInt(Integer::intValue).sum();
    }
}

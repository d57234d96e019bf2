package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.CpuTime;
import java.util.function.Supplier;

/**
 * How long something is run. The same number of steps on every machine, so that the errors are the same; only what takes far too
 * long is stopped.
 *
 * @param warmUpMillis of CPU time on something of the same kind that is thrown away: compilers are busy meanwhile
 * @param skipped steps that are not measured, for example while a pile falls
 * @param steps that are
 * @param batch steps to a batch
 * @param mostSeconds of CPU time, after which no further batch begins
 */
record Trial(int warmUpMillis, int skipped, int steps, int batch, int mostSeconds) {
    private static final long NANOS_PER_MILLI = 1_000_000;
    private static final long NANOS_PER_SECOND = 1_000_000_000;

    /** As many steps as take so long, at least three: for what is the same at every step. */
    static Trial lasting(int millis, Runnable step) {
        long nanos = Math.max(1000, CpuTime.warmUp(step, millis / 2 * NANOS_PER_MILLI));
        int steps = (int) Math.max(3, Math.min(100_000, millis * NANOS_PER_MILLI / nanos));
        return new Trial(0, 0, steps, Math.max(1, steps / 15), Integer.MAX_VALUE);
    }

    Measured run(Supplier<? extends Course> courses, int threads) {
        if (warmUpMillis > 0) {
            Course discarded = courses.get();
            CpuTime.warmUp(discarded::step, warmUpMillis * NANOS_PER_MILLI);
            discarded.end();
        }
        return run(courses.get(), threads);
    }

    Measured run(Course course, int threads) {
        StepMeter unmeasured = new StepMeter(threads);
        steps(course, skipped, unmeasured, mostSeconds * NANOS_PER_SECOND);
        StepMeter meter = new StepMeter(threads);
        steps(course, steps, meter, mostSeconds * NANOS_PER_SECOND - unmeasured.cpuNanos());
        Measured measured = new Measured(meter.cost(), course.findings());
        course.end();
        return measured;
    }

    private void steps(Course course, int count, StepMeter meter, long mostNanos) {
        int done = 0;
        while (done < count && (done == 0 || meter.cpuNanos() < mostNanos)) {
            int next = Math.min(batch, count - done);
            meter.batch(course::step, next);
            course.look();
            done += next;
        }
    }
}

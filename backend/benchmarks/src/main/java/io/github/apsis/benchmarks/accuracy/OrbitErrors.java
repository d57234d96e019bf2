package io.github.apsis.benchmarks.accuracy;

import java.util.List;

/**
 * How far a run strayed from the truth, up to each sample.
 *
 * @param momentum the largest share of all momentum under way that appeared from nowhere
 * @param bodiesLost whether a body left the world
 */
record OrbitErrors(List<AtSample> samples, double momentum, boolean bodiesLost) {
    /**
     * Errors at one sample, each in units of its scale in the case.
     *
     * @param energy largest until then
     * @param energyOncePerUnit largest until then at whole units of time alone; NaN where they are not ticks
     * @param spin largest of angular momentum until then
     * @param position at that moment; NaN when the sample falls between two ticks
     */
    record AtSample(double time, double energy, double energyOncePerUnit, double spin, double position) {
        /** The energy error to report: of fixed steps once per unit of time, as the limits were measured; else of all moments. */
        double energyOf(Method method) {
            return method == Method.ADAPTIVE || Double.isNaN(energyOncePerUnit) ? energy : energyOncePerUnit;
        }
    }

    AtSample last() {
        return samples.get(samples.size() - 1);
    }

    boolean finite() {
        return Double.isFinite(last().energy()) && Double.isFinite(last().spin()) && Double.isFinite(last().position());
    }
}

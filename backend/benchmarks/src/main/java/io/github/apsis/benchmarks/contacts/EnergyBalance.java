package io.github.apsis.benchmarks.contacts;

import io.github.apsis.engine.diagnostics.Conserved;
import java.util.List;

/**
 * The energy of a run beside what the bounces of its case leave of it.
 *
 * <pre>
 *   change(t) = (E(t) − E(0) + Σ (1 − e²) c² μ / 2) / max K
 * </pre>
 *
 * <p>The sum is over the bounces of the case up to t, with their closing speeds c and reduced masses μ; where the case lists
 * none, over those of the run. max K is the largest kinetic energy so far, and with mutual gravity that and |U(0)|.
 */
final class EnergyBalance {
    private final ContactCase known;
    private final Conserved start;
    private double scale;
    private double lowest;
    private double gain;
    private double change;

    EnergyBalance(ContactCase known, Conserved start) {
        this.known = known;
        this.start = start;
        this.lowest = energy(start);
        widen(start);
    }

    private static double energy(Conserved now) {
        return now.energy().orElse(Double.NaN);
    }

    private void widen(Conserved now) {
        double bound = known.g() == 0 ? 0 : Math.abs(start.potential().orElse(0));
        scale = Math.max(scale, now.kinetic() + bound);
    }

    /** Looks whether energy has come from nowhere, and where none may be lost, whether any was. */
    void tick(Conserved now) {
        widen(now);
        gain = Math.max(gain, share(energy(now) - lowest));
        lowest = Math.min(lowest, energy(now));
        if (known.isElastic()) {
            keepLarger(share(energy(now) - energy(start)));
        }
    }

    /** Compares with what the bounces up to now leave. */
    void compare(Conserved now, double time, List<ContactEvent> bounces) {
        List<ContactEvent> all = known.knowsEvents() ? known.events() : bounces;
        double lost = all.stream()
                .filter(event -> event.time() <= time)
                .mapToDouble(known::loss)
                .filter(loss -> !Double.isNaN(loss))
                .sum();
        keepLarger(share(energy(now) - energy(start) + lost));
    }

    private void keepLarger(double value) {
        if (Double.isNaN(value) || Math.abs(value) > Math.abs(change)) {
            change = value;
        }
    }

    private double share(double energy) {
        return energy == 0 ? 0 : energy / scale;
    }

    double change() {
        return change;
    }

    double gain() {
        return gain;
    }
}

package io.github.apsis.benchmarks.contacts;

import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.math.CompensatedSum;
import java.util.List;

/**
 * The energy of a run beside what the bounces of its case leave of it.
 *
 * <pre>
 *   change(t) = (E(t) − E(0) + Σ (1 − e²) c² μ / 2) / max K
 * </pre>
 *
 * <p>The sum is over the bounces of the case up to t, with their closing speeds c and reduced masses μ; where the case lists
 * none, over those of the run. The work of a uniform field is taken from where the bodies started, so that a scene far from
 * the origin is measured no worse. max K is the largest kinetic energy of the run, and with mutual gravity that and |U(0)|.
 */
final class EnergyBalance {
    private final ContactCase known;
    private final Conserved start;
    private final WorldSnapshot first;
    private double scale;
    private double lowest; // E − E(0), as the two below
    private double gain;
    private double change;

    EnergyBalance(ContactCase known, Conserved start, WorldSnapshot first) {
        this.known = known;
        this.start = start;
        this.first = first;
        widen(start);
    }

    private void widen(Conserved now) {
        double bound = known.g() == 0 ? 0 : Math.abs(start.potential().orElse(0));
        scale = Math.max(scale, now.kinetic() + bound);
    }

    private double risen(Conserved now, WorldSnapshot state) {
        return known.g() == 0
                ? now.kinetic() - start.kinetic() - work(state)
                : now.energy().orElse(Double.NaN) - start.energy().orElse(Double.NaN);
    }

    /** Of the uniform field since the start. */
    private double work(WorldSnapshot state) {
        var work = new CompensatedSum();
        for (int i = 0; i < Math.min(state.count(), first.count()); i++) {
            work.add(state.mass(i) * known.fieldX() * (state.x(i) - first.x(i)));
            work.add(state.mass(i) * known.fieldY() * (state.y(i) - first.y(i)));
        }
        return work.value();
    }

    /** Looks whether energy has come from nowhere, and where none may be lost, whether any was. */
    void tick(Conserved now, WorldSnapshot state) {
        double risen = risen(now, state);
        widen(now);
        gain = Math.max(gain, risen - lowest); // NaN stays
        lowest = Math.min(lowest, risen);
        if (known.isElastic()) {
            keepLarger(risen);
        }
    }

    /** Compares with what the bounces up to now leave. */
    void compare(Conserved now, WorldSnapshot state, double time, List<ContactEvent> bounces) {
        List<ContactEvent> all = known.knowsEvents() ? known.events() : bounces;
        double lost = all.stream()
                .filter(event -> event.time() <= time)
                .mapToDouble(known::loss)
                .filter(loss -> !Double.isNaN(loss))
                .sum();
        keepLarger(risen(now, state) + lost);
    }

    private void keepLarger(double value) {
        if (Double.isNaN(value) || Math.abs(value) > Math.abs(change)) {
            change = value;
        }
    }

    /** The largest that was compared, signed. */
    double change() {
        return share(change);
    }

    /** The largest rise above any earlier moment. */
    double gain() {
        return share(gain);
    }

    private double share(double energy) {
        return energy == 0 ? 0 : energy / scale;
    }
}

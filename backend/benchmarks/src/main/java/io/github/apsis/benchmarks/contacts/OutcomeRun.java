package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.diagnostics.Conserved;
import java.util.Locale;

/**
 * Lets discs meet, and compares the velocities with which they leave. The outcome is that of impulses at one instant; where a
 * set-up is its own mirror image, another outcome that is so too, keeps momentum and gains no energy is tolerated.
 */
final class OutcomeRun {
    private static final double SAME = 1e-9;
    private static final double MOMENTUM_KEPT = 1e-14;
    private static final double ENERGY_GAINED = 1e-13;
    private static final int LENGTHS =
            2; // of the whole set-up, at the speed of the fastest: long enough to meet and part

    private final OutcomeCase known;
    private final ContactMode mode;

    OutcomeRun(OutcomeCase known, ContactMode mode) {
        this.known = known;
        this.mode = mode;
    }

    ContactRow row() {
        double dt = 1.0 / SampleTicks.ROOM;
        World world = new World(
                mode.on(WorldSpec.builder().dt(dt), known.restitution()).build());
        known.bodies().forEach(world::add);
        WorldSnapshot before = world.snapshot();
        Conserved start = world.conserved();
        var momentum = new MomentumBalance(start, 0);
        long ticks = (long) Math.ceil(LENGTHS * known.extent() / known.fastest() / dt);
        for (long tick = 0; tick < ticks; tick++) {
            world.step();
        }
        WorldSnapshot after = world.snapshot();
        Conserved end = world.conserved();
        momentum.tick(end);
        double gain = (end.kinetic() - start.kinetic()) / start.kinetic();
        double none = Double.NaN;
        return new ContactRow(
                known.id(),
                mode,
                "",
                none,
                none,
                error(after),
                (end.kinetic() - kinetic(after)) / start.kinetic(),
                momentum.error(),
                status(before, after, momentum.error(), gain));
    }

    /** The largest difference of a body's velocity from that of the outcome, relative to the fastest at the start. */
    private double error(WorldSnapshot after) {
        double worst = 0;
        for (int i = 0; i < after.count(); i++) {
            double error = Math.hypot(after.vx(i) - vx(after, i), after.vy(i) - vy(i));
            worst = Math.max(worst, error / known.fastest());
        }
        return worst;
    }

    private double vx(WorldSnapshot after, int i) {
        double vx = known.outcome()[i][0];
        return Double.isNaN(vx) ? after.vx(i) : vx;
    }

    /** What goes along x and says no vy has none. */
    private double vy(int i) {
        double vy = known.outcome()[i][1];
        return Double.isNaN(vy) ? 0 : vy;
    }

    private double kinetic(WorldSnapshot after) {
        double sum = 0;
        for (int i = 0; i < after.count(); i++) {
            sum += 0.5 * after.mass(i) * (vx(after, i) * vx(after, i) + vy(i) * vy(i));
        }
        return sum;
    }

    private String status(WorldSnapshot before, WorldSnapshot after, double momentum, double gain) {
        if (momentum > MOMENTUM_KEPT) {
            return complaint("momentum", momentum, MOMENTUM_KEPT);
        }
        if (gain > ENERGY_GAINED) {
            return complaint("energy gained", gain, ENERGY_GAINED);
        }
        double error = error(after);
        return error <= SAME || Mirror.isKept(before, after, SAME * known.fastest())
                ? ContactVerdict.OK
                : complaint("velocity", error, SAME);
    }

    private static String complaint(String what, double error, double limit) {
        return ContactVerdict.OUTSIDE + String.format(Locale.ROOT, "%s %.1e > %.1e", what, error, limit);
    }
}

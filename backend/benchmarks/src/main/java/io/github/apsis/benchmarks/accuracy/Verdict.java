package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.report.Cells;
import java.util.List;
import java.util.Locale;

/**
 * What to say of a run: {@code ok}, or why not.
 *
 * <p>Energy is judged as the limits were measured: once per unit of time where a unit is a whole number of ticks. It matters
 * where a unit is the period of an orbit: the energy of Yoshida's method swings within it and returns, and the hierarchical
 * triples have limits 200 and 30 000 times below the swing of the very program that set them.
 */
final class Verdict {
    static final String OK = "ok";
    static final String OUTSIDE = "outside tolerance";
    static final String CANNOT_FOLLOW = "cannot follow";
    static final String FAILED = "failed: ";
    static final String SKIPPED = "skipped: ";

    private static final double LOST = 1; // an energy error of the whole energy: another motion altogether
    private static final double MOMENTUM_KEPT = 1e-10; // rounding of 10⁷ ticks is 10⁻¹²

    private Verdict() {}

    /** Judges against the limits, and without any by whether the run stayed with the case at all. */
    static String of(OrbitErrors errors, List<Tolerances.Limit> limits) {
        if (errors.bodiesLost()) {
            return CANNOT_FOLLOW + ": a body left the world";
        }
        if (!errors.finite()) {
            return FAILED + "a figure is not finite";
        }
        if (errors.momentum() > MOMENTUM_KEPT) {
            return FAILED + String.format(Locale.ROOT, "momentum changed by %.1e", errors.momentum());
        }
        boolean asked = false;
        for (Tolerances.Limit limit : limits) {
            asked |= Double.isFinite(limit.position()) || Double.isFinite(limit.energy());
            for (OrbitErrors.AtSample sample : errors.samples()) {
                String broken = sample.time() == limit.until() ? broken(sample, limit) : "";
                if (!broken.isEmpty()) {
                    return OUTSIDE + ": " + broken;
                }
            }
        }
        return asked || errors.last().energy() <= LOST ? OK : CANNOT_FOLLOW;
    }

    private static String broken(OrbitErrors.AtSample at, Tolerances.Limit limit) {
        if (at.position() > limit.position()) {
            return compared("position", at.position(), limit.position(), at.time());
        }
        if (at.energy() > limit.energy() && !returns(at, limit)) {
            return compared("energy", at.energy(), limit.energy(), at.time());
        }
        return at.spin() > limit.spin() ? compared("L", at.spin(), limit.spin(), at.time()) : "";
    }

    private static boolean returns(OrbitErrors.AtSample at, Tolerances.Limit limit) {
        return at.energyOncePerUnit() <= limit.energy();
    }

    /** Whether a run is within its limits only where the swing of its energy has returned. */
    static boolean swings(OrbitErrors errors, List<Tolerances.Limit> limits) {
        return limits.stream().anyMatch(limit -> errors.samples().stream()
                .anyMatch(at -> at.time() == limit.until() && at.energy() > limit.energy() && returns(at, limit)));
    }

    private static String compared(String what, double error, double limit, double time) {
        return String.format(Locale.ROOT, "%s %.1e > %.1e at T=", what, error, limit) + Cells.plain(time);
    }

    static boolean isFailed(String status) {
        return status.startsWith(FAILED);
    }

    /** Whether a status must fail the command. */
    static boolean isBad(String status) {
        return status.startsWith(OUTSIDE) || isFailed(status);
    }
}

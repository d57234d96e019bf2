package io.github.apsis.benchmarks.steering;

import io.github.apsis.benchmarks.report.Csv;
import java.util.List;
import java.util.Locale;

/**
 * One line of {@code steering.csv}: a scene with a method, all seeds together.
 *
 * @param worst events per ship-minute of the worst instance
 */
record SteeringRow(String scene, Contender method, String seeds, SteeringTally tally, double worst) {
    static final String HEADER =
            "scene,method,seeds,collisions_per_min,hit_pct,min_clearance,arrived_pct,time_ratio,jerk,turn,cost_ms_per_1000";

    String csv() {
        return Csv.line(
                scene,
                method.label(),
                seeds,
                number("%.5f", tally.collisionsPerMinute()),
                number("%.3f", tally.hitPercent()),
                number("%.3f", tally.minClearance),
                number("%.2f", tally.docks ? tally.arrivedPercent() : Double.NaN),
                number("%.4f", tally.timeRatio()),
                number("%.3f", tally.jerk()),
                number("%.2f", tally.turnDegrees()),
                number("%.4f", tally.costMillis()));
    }

    List<String> cells() {
        return List.of(
                scene,
                method.label(),
                seeds,
                number("%.4f", tally.collisionsPerMinute()),
                number("%.4f", worst),
                number("%.1f", tally.hitPercent()),
                number("%.1f", tally.minClearance),
                number("%.1f", tally.docks ? tally.arrivedPercent() : Double.NaN),
                number("%.3f", tally.timeRatio()),
                number("%.0f", tally.meanSpeed()),
                number("%.1f", tally.jerk()),
                number("%.2f", tally.costMillis()));
    }

    /** Empty where there is nothing to tell. */
    private static String number(String format, double value) {
        return Double.isFinite(value) ? String.format(Locale.ROOT, format, value) : "";
    }
}

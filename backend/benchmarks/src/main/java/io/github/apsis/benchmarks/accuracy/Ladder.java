package io.github.apsis.benchmarks.accuracy;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The settings to measure a case with: fixed steps of 2^k / 150, the adaptive method over its tolerances with ticks as long as
 * the samples allow, and once with the ticks of a room.
 *
 * @param only the methods to measure
 * @param dt the one step to take instead of the ladder
 * @param tolerance the one tolerance to take instead of the ladder
 */
public record Ladder(List<Method> only, @Nullable Double dt, @Nullable Double tolerance, Thoroughness thoroughness) {
    static final double ROOM = 1.0 / 150;
    private static final double[] TOLERANCES = {
        1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16
    };
    private static final double[] FEW_TOLERANCES = {1e-10, 1e-16};
    private static final int FINEST = -1; // 1/300
    private static final int COARSEST_FOR_ALL = 2; // 1/37.5

    /** A quick look, or everything. */
    public enum Thoroughness {
        SHORT,
        FULL
    }

    List<Setting> of(NBodyCase orbit) {
        List<Setting> settings = new ArrayList<>();
        for (Method method : only) {
            if (method == Method.ADAPTIVE) {
                addAdaptive(orbit, settings);
            } else {
                addFixed(orbit, method, settings);
            }
        }
        return settings;
    }

    private void addFixed(NBodyCase orbit, Method method, List<Setting> settings) {
        if (dt != null) {
            settings.add(Setting.fixed(method, Ticks.fitting(dt, orbit)));
            return;
        }
        for (int k = coarsest(orbit, method); k >= finest(); k--) {
            settings.add(Setting.fixed(method, Ticks.fitting(Math.scalb(ROOM, k), orbit)));
        }
    }

    private int finest() {
        return thoroughness == Thoroughness.SHORT ? 0 : FINEST;
    }

    private int coarsest(NBodyCase orbit, Method method) {
        if (thoroughness == Thoroughness.SHORT) {
            return 1;
        }
        int k = COARSEST_FOR_ALL;
        while (Math.scalb(ROOM, k + 1) * method.stepsPerPeriod() <= orbit.period()) {
            k++;
        }
        return k;
    }

    private void addAdaptive(NBodyCase orbit, List<Setting> settings) {
        double tick = Ticks.fitting(dt != null ? dt : Ticks.longest(orbit), orbit);
        for (double value : tolerances()) {
            settings.add(Setting.adaptive(tick, value));
        }
        if (dt == null && tolerance == null) {
            settings.add(Setting.adaptive(Ticks.fitting(ROOM, orbit), Tolerances.ADAPTIVE_DEFAULT));
        }
    }

    private double[] tolerances() {
        if (tolerance != null) {
            return new double[] {tolerance};
        }
        return thoroughness == Thoroughness.SHORT ? FEW_TOLERANCES : TOLERANCES;
    }
}

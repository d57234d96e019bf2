package io.github.apsis.benchmarks.cli;

import io.github.apsis.benchmarks.SceneRun;
import io.github.apsis.benchmarks.TickTimes;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;

/** What {@code run} says: a table for people, or a JSON object for programs. */
record RunReport(String scene, long seed, SceneRun.Result result) {
    String table() {
        return String.format(
                Locale.ROOT,
                """
                scene             %s, seed %d
                bodies            %d
                machine           %s
                ticks             %d, after %d to warm up
                ticks per second  %.0f
                real-time factor  %.1f at 150 ticks a second
                time per tick     p50 %s, p99 %s, max %s
                allocated         %.1f bytes per tick
                energy drift      %s
                momentum drift    %.2e
                state hash        %s""",
                scene,
                seed,
                result.bodies(),
                Jdk.name(),
                times().count(),
                result.warmUpTicks(),
                ticksPerSecond(),
                realTimeFactor(),
                micros(times().percentileNanos(0.5)),
                micros(times().percentileNanos(0.99)),
                micros(times().maxNanos()),
                allocatedPerTick(),
                energyDrift("%+.2e", "not defined: a force law has no potential"),
                result.drift().momentum(),
                hash());
    }

    String json() {
        Map<String, String> facts = new LinkedHashMap<>();
        facts.put("scene", quoted(scene));
        facts.put("seed", String.valueOf(seed));
        facts.put("bodies", String.valueOf(result.bodies()));
        facts.put("machine", quoted(Jdk.name()));
        facts.put("ticks", String.valueOf(times().count()));
        facts.put("warmUpTicks", String.valueOf(result.warmUpTicks()));
        facts.put("ticksPerSecond", number("%.1f", ticksPerSecond()));
        facts.put("realTimeFactor", number("%.3f", realTimeFactor()));
        facts.put("tickNanosP50", String.valueOf(times().percentileNanos(0.5)));
        facts.put("tickNanosP99", String.valueOf(times().percentileNanos(0.99)));
        facts.put("tickNanosMax", String.valueOf(times().maxNanos()));
        facts.put("allocatedBytesPerTick", number("%.1f", allocatedPerTick()));
        facts.put("energyDrift", energyDrift("%.6e", "null"));
        facts.put("momentumDrift", number("%.6e", result.drift().momentum()));
        facts.put("stateHash", quoted(hash()));
        return facts.entrySet().stream()
                .map(fact -> quoted(fact.getKey()) + ":" + fact.getValue())
                .collect(Collectors.joining(",", "{", "}"));
    }

    private TickTimes times() {
        return result.times();
    }

    private double ticksPerSecond() {
        return times().count() / (times().totalNanos() * 1e-9);
    }

    private double realTimeFactor() {
        return ticksPerSecond() / SceneRun.TICKS_PER_SECOND;
    }

    private double allocatedPerTick() {
        return (double) result.allocatedBytes() / times().count();
    }

    private String energyDrift(String format, String undefined) {
        var drift = result.drift().energy();
        return drift.isPresent() ? number(format, drift.getAsDouble()) : undefined;
    }

    private String hash() {
        return "%016x".formatted(result.stateHash());
    }

    private static String micros(long nanos) {
        return number("%.1f µs", nanos / 1000.0);
    }

    /** With a point, whatever the country. */
    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }

    private static String quoted(String text) {
        return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }
}

package io.github.apsis.benchmarks.cli;

import io.github.apsis.benchmarks.Balance;
import io.github.apsis.benchmarks.SceneRun;
import io.github.apsis.benchmarks.TickTimes;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Collectors;

/** What {@code run} says: a table for people, or a JSON object for programs. */
record RunReport(String scene, long seed, int threads, SceneRun.Result result) {
    private static final String UNDEFINED_ENERGY = "not defined: a force law has no potential";

    String table() {
        return String.format(
                Locale.ROOT,
                """
                scene             %s, seed %d
                bodies            %s
                machine           %s
                threads           %d
                ticks             %d, after %d to warm up
                ticks per second  %.0f
                real-time factor  %.1f at 150 ticks a second
                time per tick     p50 %s, p99 %s, max %s
                allocated         %.1f bytes per tick, after %d in the first
                energy            %s
                energy drift      %s
                momentum drift    %.2e, at worst %.2e
                angular drift     %s
                overlap           at worst %.2e of the smaller radius, at %.0f s
                touching pairs    at most %d
                state hash        %s""",
                scene,
                seed,
                bodies(),
                Jdk.name(),
                threads,
                times().count(),
                result.warmUpTicks(),
                ticksPerSecond(),
                realTimeFactor(),
                micros(times().percentileNanos(0.5)),
                micros(times().percentileNanos(0.99)),
                micros(times().maxNanos()),
                allocatedPerTick(),
                result.firstTickBytes(),
                energy(),
                energyDrift(),
                balance().drift().momentum(),
                balance().worstMomentumDrift(),
                angularDrift(),
                balance().deepestOverlap(),
                balance().deepestOverlapTime(),
                balance().mostTouching(),
                hash());
    }

    String json() {
        Map<String, String> facts = new LinkedHashMap<>();
        facts.put("scene", quoted(scene));
        facts.put("seed", String.valueOf(seed));
        facts.put("bodies", String.valueOf(balance().bodies()));
        facts.put("bodiesAtStart", String.valueOf(balance().bodiesAtStart()));
        facts.put("departures", String.valueOf(balance().departures()));
        facts.put("machine", quoted(Jdk.name()));
        facts.put("threads", String.valueOf(threads));
        facts.put("ticks", String.valueOf(times().count()));
        facts.put("warmUpTicks", String.valueOf(result.warmUpTicks()));
        facts.put("ticksPerSecond", number("%.1f", ticksPerSecond()));
        facts.put("realTimeFactor", number("%.3f", realTimeFactor()));
        facts.put("tickNanosP50", String.valueOf(times().percentileNanos(0.5)));
        facts.put("tickNanosP99", String.valueOf(times().percentileNanos(0.99)));
        facts.put("tickNanosMax", String.valueOf(times().maxNanos()));
        facts.put("allocatedBytesInFirstTick", String.valueOf(result.firstTickBytes()));
        facts.put("allocatedBytesPerTick", number("%.1f", allocatedPerTick()));
        facts.put("energyChange", number(balance().energyChange()));
        facts.put("bookedWork", number("%.6e", balance().work()));
        facts.put("energyDrift", number(balance().drift().energy()));
        facts.put("worstEnergyDrift", number("%.6e", balance().worstEnergyDrift()));
        facts.put("momentumDrift", number("%.6e", balance().drift().momentum()));
        facts.put("worstMomentumDrift", number("%.6e", balance().worstMomentumDrift()));
        facts.put("angularMomentumDrift", number(balance().drift().angularMomentum()));
        facts.put("worstAngularMomentumDrift", number("%.6e", balance().worstAngularMomentumDrift()));
        facts.put("deepestOverlap", number("%.6e", balance().deepestOverlap()));
        facts.put("mostTouchingPairs", String.valueOf(balance().mostTouching()));
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
        return (double) result.allocatedBytes() / Math.max(1, times().count() - 1);
    }

    private String bodies() {
        return balance().bodies() == balance().bodiesAtStart() && balance().departures() == 0
                ? String.valueOf(balance().bodies())
                : "%d, of %d at the start; %d left of themselves"
                        .formatted(
                                balance().bodies(),
                                balance().bodiesAtStart(),
                                balance().departures());
    }

    private String energy() {
        var change = balance().energyChange();
        return change.isPresent()
                ? number("changed by %+.6e", change.getAsDouble())
                        + number(", booked are %+.6e", balance().work())
                : UNDEFINED_ENERGY;
    }

    private String energyDrift() {
        var drift = balance().drift().energy();
        return drift.isPresent()
                ? number("%+.2e", drift.getAsDouble())
                        + number(", at worst %.2e", balance().worstEnergyDrift())
                : UNDEFINED_ENERGY;
    }

    private String angularDrift() {
        var drift = balance().drift().angularMomentum();
        return drift.isPresent()
                ? number("%+.2e", drift.getAsDouble())
                        + number(", at worst %.2e", balance().worstAngularMomentumDrift())
                : "not defined: a place is known up to a period only, or nothing has mass";
    }

    private Balance balance() {
        return result.balance();
    }

    private String hash() {
        return "%016x".formatted(result.stateHash());
    }

    private static String micros(long nanos) {
        return number("%.1f µs", nanos / 1000.0);
    }

    private static String number(OptionalDouble value) {
        return value.isPresent() ? number("%.6e", value.getAsDouble()) : "null";
    }

    /** With a point, whatever the country. */
    private static String number(String format, double value) {
        return String.format(Locale.ROOT, format, value);
    }

    private static String quoted(String text) {
        return '"' + text.replace("\\", "\\\\").replace("\"", "\\\"") + '"';
    }
}

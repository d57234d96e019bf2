package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.Overlaps;
import io.github.apsis.benchmarks.SceneRun;
import io.github.apsis.benchmarks.TickTimes;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.body.BodyKind;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;

/** A world that attracts, minute by minute: how long its ticks take by the clock, and the error of its forces at the end of each. */
final class LongCourse implements Course {
    private static final int MINUTE = 60 * SceneRun.TICKS_PER_SECOND; // steps
    private static final long PERIOD = 1_000_000_000L / SceneRun.TICKS_PER_SECOND; // ns
    private static final double MS = 1e-6;

    private final World world;
    private final List<TickTimes> minutes = new ArrayList<>();
    private TickTimes minute = new TickTimes();
    private long late;
    private long steps;
    private final List<List<Finding>> forces = new ArrayList<>();

    LongCourse(World world) {
        this.world = world;
        minutes.add(minute);
    }

    @Override
    public void step() {
        long before = System.nanoTime();
        world.step();
        long took = System.nanoTime() - before;
        minute.record(took);
        late += took > PERIOD ? 1 : 0;
        steps++;
    }

    @Override
    public void look() {
        if (minute.count() >= MINUTE) {
            forces.add(forceErrors());
            minute = new TickTimes(); // not in a step, whose allocations are measured
            minutes.add(minute);
        }
    }

    private List<Finding> forceErrors() {
        WorldSnapshot now = world.snapshot();
        // The first is the planet, which is fixed; ships have engines.
        IntPredicate isFree = body -> body > 0 && now.kind(body) != BodyKind.SHIP;
        return ForceCheck.of(now, world.spec(), isFree);
    }

    @Override
    public List<Finding> findings() {
        forces.add(forceErrors());
        List<Finding> findings = new ArrayList<>();
        for (int kind = 0; kind < forces.get(0).size(); kind++) {
            findings.add(worst(kind));
        }
        findings.add(new Finding(
                "overlap",
                Overlaps.of(world.snapshot(), world.spec().boundary()).deepest()));
        findings.add(new Finding("p99-first-minute", MS * minutes.get(0).percentileNanos(0.99)));
        findings.add(new Finding("p99-last-minute", MS * lastMinute().percentileNanos(0.99)));
        findings.add(new Finding(
                "max",
                MS * minutes.stream().mapToLong(TickTimes::maxNanos).max().orElse(0)));
        findings.add(new Finding("late", (double) late / Math.max(1, steps)));
        return findings;
    }

    /** The last whole one, or the only one. */
    private TickTimes lastMinute() {
        return minutes.size() > 1 && minute.count() < MINUTE ? minutes.get(minutes.size() - 2) : minute;
    }

    private Finding worst(int kind) {
        Finding worst = forces.get(0).get(kind);
        for (List<Finding> look : forces) {
            worst = look.get(kind).value() > worst.value() ? look.get(kind) : worst;
        }
        return worst;
    }

    @Override
    public void end() {
        world.close();
    }
}

package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.discs.Contender;
import io.github.apsis.benchmarks.discs.DiscScene;
import io.github.apsis.benchmarks.discs.DiscScenes;
import io.github.apsis.benchmarks.speed.SpeedStudy.Length;

/** S2 before it is settled: discs fall together and come to rest. */
final class FallScene implements SpeedScene {
    private static final int[] FEW = {10, 25};
    private static final int[] SOME = {100, 1000};
    private static final int[] MANY = {100, 1000, 5000};
    private static final int STEPS = 1200;
    private static final int WARM_UP = 3000; // ms, in which a hundred discs fall and lie

    @Override
    public String name() {
        return "s2-fall";
    }

    @Override
    public String description() {
        return "Discs of radius 2 and restitution 0.2 that fall into a box under a field of 100, for eight seconds from their first step on. Ticks differ much: free fall, collapse, calm and"
                + " rest; `seconds` is what all of them took by the clock, `ms` the median batch of twenty."
                + " `overlap`: the deepest seen between batches, radii; `overlap-mean-end`: what is left.";
    }

    @Override
    public void run(Bench bench) {
        Trial whole = new Trial(WARM_UP, 0, STEPS, 20, Integer.MAX_VALUE);
        Trial trial = bench.choose(new Trial(0, 0, 60, 20, 5), whole, whole);
        for (int n : bench.choose(FEW, SOME, MANY)) {
            DiscScene scene = DiscScenes.pile(n);
            Contender.BY_TICKS.stream()
                    .filter(engine -> engine.isOurs() || bench.length() == Length.FULL || engine == Contender.DYN4J)
                    .forEach(engine -> bench.measure(
                            name(), engine.id(), n, trial, () -> new ClockedCourse(new DiscCourse(scene, engine))));
        }
    }
}

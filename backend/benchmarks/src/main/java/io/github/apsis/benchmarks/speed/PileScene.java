package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.discs.Contender;
import io.github.apsis.benchmarks.discs.DiscScene;
import io.github.apsis.benchmarks.discs.DiscScenes;
import io.github.apsis.benchmarks.speed.SpeedStudy.Length;

/** S2: a pile that has had eight seconds to come to rest. */
final class PileScene implements SpeedScene {
    private static final int[] FEW = {10, 25};
    private static final int[] SOME = {10, 100, 1000};
    private static final int[] MANY = {10, 100, 1000, 5000};
    private static final int MOST_OF_OTHERS = 1000; // in a short run: 5000 take dyn4j and JBox2D two minutes each
    private static final int MOST_SECONDS =
            1200; // a heap that is measured while it falls would say nothing of one at rest

    @Override
    public String name() {
        return "s2-pile";
    }

    @Override
    public String description() {
        return "Discs of radius 2 and restitution 0.2 that fall into a box under a field of 100, for ten seconds, of which the"
                + " last two are measured. `overlap`: the deepest ever seen between batches, radii; `overlap-end` and"
                + " `overlap-mean-end`: at the end; `kinetic-energy-end` and `fastest-end`: of what still moves then, where masses"
                + " are 1 and the field gives 0.67 in a tick.";
    }

    @Override
    public void run(Bench bench) {
        for (int n : bench.choose(FEW, SOME, MANY)) {
            DiscScene scene = DiscScenes.pile(n);
            Trial settled = new Trial(n <= 100 ? 500 : 0, 1200, 300, 20, MOST_SECONDS);
            Trial trial = bench.choose(new Trial(0, 60, 60, 20, 5), settled, settled);
            Contender.BY_TICKS.stream()
                    .filter(engine -> engine.isOurs() || bench.length() == Length.FULL || isBriefEnough(engine, n))
                    .forEach(engine ->
                            bench.measure(name(), engine.id(), n, trial, () -> new DiscCourse(scene, engine)));
        }
    }

    /** One of the two cheaper modes of dyn4j will do. */
    private static boolean isBriefEnough(Contender engine, int n) {
        return n <= MOST_OF_OTHERS && (n < MOST_OF_OTHERS || engine != Contender.DYN4J_BULLETS_ONLY);
    }
}

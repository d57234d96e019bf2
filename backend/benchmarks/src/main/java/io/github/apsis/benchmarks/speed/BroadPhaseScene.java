package io.github.apsis.benchmarks.speed;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongFunction;
import java.util.function.Supplier;
import java.util.stream.LongStream;

/** The broad phase alone: all pairs that overlap, from scratch. */
final class BroadPhaseScene implements SpeedScene {
    private static final Map<String, Supplier<PairFinder>> FINDERS = new LinkedHashMap<>();
    private static final String JTS = "jts-quadtree";
    private static final int SETS = 4;

    static {
        FINDERS.put("apsis", CircleGridPairs::new);
        FINDERS.put("apsis-quadtree", QuadtreePairs::new);
        FINDERS.put("grid", GridPairs::new);
        FINDERS.put(JTS, JtsPairs::new);
    }

    /** How large the circles are. */
    enum Radii {
        EQUAL("broad-phase", "All overlapping pairs of circles of one size strewn over a square, a fifth of its area"),
        MIXED("broad-phase-mixed", "The same with radii from 1 to 100, of a density falling as r⁻³");

        private final String scene;
        private final String sentence;

        Radii(String scene, String sentence) {
            this.scene = scene;
            this.sentence = sentence;
        }

        Circles circles(int count, long seed) {
            return this == EQUAL ? Circles.equal(count, seed) : Circles.mixed(count, seed);
        }
    }

    private final Radii radii;

    BroadPhaseScene(Radii radii) {
        this.radii = radii;
    }

    @Override
    public String name() {
        return radii.scene;
    }

    @Override
    public String description() {
        return radii.sentence + ", from scratch. `pairs-wrong`: missed or invented, as a share of the true ones.";
    }

    @Override
    public void run(Bench bench) {
        int[] brief = {10, 100, 1000, 5000, 20_000, 100_000};
        for (int n : bench.choose(new int[] {10, 100}, brief, brief)) {
            LongFunction<Circles> one = seed -> radii.circles(n, seed);
            List<Circles> sets = LongStream.range(0, SETS).mapToObj(one).toList();
            FINDERS.forEach((label, finder) -> {
                if (n <= most(label, bench)) {
                    bench.measure(
                            name(), label, n, bench.choose(20, 300, 1500), () -> new PairCourse(sets, finder.get()));
                }
            });
        }
    }

    /** JTS takes seconds beyond. */
    private static int most(String finder, Bench bench) {
        return finder.equals(JTS) ? bench.choose(100, 5000, 20_000) : Integer.MAX_VALUE;
    }
}

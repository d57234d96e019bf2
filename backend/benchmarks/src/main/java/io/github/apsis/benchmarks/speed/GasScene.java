package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.discs.Contender;
import io.github.apsis.benchmarks.discs.DiscScene;
import io.github.apsis.benchmarks.discs.DiscScenes;
import io.github.apsis.benchmarks.speed.SpeedStudy.Length;

/** S1: elastic discs, a fifth of the area. */
final class GasScene implements SpeedScene {
    private static final int[] FEW = {10, 50};
    private static final int[] SOME = {10, 100, 1000, 5000, 20_000, 100_000};

    @Override
    public String name() {
        return "s1-gas";
    }

    @Override
    public String description() {
        return "Elastic discs of radius 2 at speed 60, a fifth of the area of a closed box. `energy-drift`: of kinetic energy,"
                + " relative, from the first step to the last; `overlap`: the deepest seen between batches, radii.";
    }

    @Override
    public void run(Bench bench) {
        for (int n : bench.choose(FEW, SOME, SOME)) {
            DiscScene scene = DiscScenes.gas(n);
            Contender.BY_TICKS.stream()
                    .filter(engine -> engine.isOurs() || n <= bench.choose(50, 5000, 20_000))
                    .forEach(engine -> bench.measure(
                            name(), engine.id(), n, trial(bench, n), () -> new DiscCourse(scene, engine)));
        }
    }

    private static Trial trial(Bench bench, int n) {
        if (n <= 1000) {
            return bench.choose(
                    new Trial(100, 20, 40, 20, 5),
                    new Trial(300, 100, 300, 20, 20),
                    new Trial(2000, 300, 1200, 20, 60));
        }
        Trial many = n <= 5000 ? new Trial(2000, 300, 1200, 20, 60) : new Trial(2000, 60, 240, 10, 60);
        return bench.length() == Length.FULL ? many : new Trial(300, 20, 60, 10, 20);
    }
}

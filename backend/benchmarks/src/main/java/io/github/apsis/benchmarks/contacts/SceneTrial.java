package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.CpuTime;
import io.github.apsis.benchmarks.discs.Contender;
import io.github.apsis.benchmarks.discs.DiscEngine;
import io.github.apsis.benchmarks.discs.DiscOverlaps;
import io.github.apsis.benchmarks.discs.DiscScene;
import java.util.Arrays;

/**
 * Runs a scene in an engine, times each step by itself, and looks every ten steps how deep discs are in each other. A run that
 * takes too long stops where it is and says so.
 *
 * @param steps of the whole run
 * @param timedFrom the first step that counts: before, compilers are busy and piles are in the air
 * @param mostSeconds of CPU time
 */
record SceneTrial(DiscScene scene, int steps, int timedFrom, int mostSeconds) {
    private static final int LOOK_EVERY = 10;
    private static final long NANOS = 1_000_000_000;

    SceneRow run(Contender contender) {
        DiscEngine engine = contender.run(scene);
        double start = scene.kineticEnergy(engine);
        double deepest = 0;
        long[] nanos = new long[steps];
        long spent = 0;
        int done = 0;
        while (done < steps
                && spent < mostSeconds * NANOS
                && !Thread.currentThread().isInterrupted()) {
            nanos[done] = CpuTime.nanosOnce(engine::step);
            spent += nanos[done];
            done++;
            if (done % LOOK_EVERY == 0) {
                deepest = Math.max(deepest, DiscOverlaps.of(scene, engine).deepest());
            }
        }
        DiscOverlaps end = DiscOverlaps.of(scene, engine);
        long[] timed = Arrays.copyOfRange(nanos, done > timedFrom ? timedFrom : done / 2, done);
        Arrays.sort(timed);
        double kinetic = scene.kineticEnergy(engine);
        return new SceneRow(
                scene.name(),
                scene.discs().size(),
                contender,
                done,
                timed[timed.length / 2] * 1e-3,
                timed[(int) Math.min(timed.length - 1L, timed.length * 99L / 100)] * 1e-3,
                scene.restitution() == 1 && start > 0 ? kinetic / start - 1 : Double.NaN,
                Math.max(deepest, end.deepest()),
                end.deepest(),
                end.mean(),
                Math.sqrt(2 * kinetic / mass()),
                done < steps ? "stopped after " + mostSeconds + " s" : "");
    }

    private double mass() {
        return scene.discs().stream().mapToDouble(DiscScene.Disc::mass).sum();
    }
}

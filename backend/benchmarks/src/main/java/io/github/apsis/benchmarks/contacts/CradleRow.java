package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.discs.Contender;
import io.github.apsis.benchmarks.discs.DiscEngine;
import io.github.apsis.benchmarks.discs.DiscScene;
import io.github.apsis.benchmarks.discs.DiscScenes;
import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.benchmarks.report.Csv;

/**
 * One line of {@code cradles.csv}: the last disc must leave with the speed of the first, and all others rest.
 *
 * @param speedError the largest of all discs, relative to that speed
 */
record CradleRow(String scene, Contender engine, double speedError) {
    static final String HEADER = "scene,engine,speed_error";

    private static final int STEPS = 150;

    static CradleRow of(DiscScene scene, Contender contender) {
        DiscEngine engine = contender.run(scene);
        for (int step = 0; step < STEPS; step++) {
            engine.step();
        }
        int last = scene.discs().size() - 1;
        double worst = 0;
        for (int i = 0; i <= last; i++) {
            double right = i == last ? DiscScenes.CRADLE_SPEED : 0;
            worst = Math.max(worst, Math.hypot(engine.vx(i) - right, engine.vy(i)));
        }
        return new CradleRow(scene.name(), contender, worst / DiscScenes.CRADLE_SPEED);
    }

    String csv() {
        return Csv.line(scene, engine.label(), Cells.exact(speedError));
    }
}

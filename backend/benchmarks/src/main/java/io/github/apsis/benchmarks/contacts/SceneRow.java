package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.discs.Contender;
import io.github.apsis.benchmarks.discs.DiscScene;
import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.benchmarks.report.Csv;

/**
 * One line of {@code scenes.csv}: a scene in an engine.
 *
 * @param steps that were run
 * @param micros CPU time of a step, median of those that were timed
 * @param p99Micros the same, 99 of 100 take no longer
 * @param energyDrift of kinetic energy, relative; NaN where it is not kept by right
 * @param deepest overlap ever seen, radii
 * @param deepestEnd overlap at the end, radii
 * @param meanEnd overlap at the end of those that overlap, radii
 * @param speedEnd root mean square, length / time
 * @param note why it stopped before its end; empty when it did not
 */
record SceneRow(
        String scene,
        int bodies,
        Contender engine,
        int steps,
        double micros,
        double p99Micros,
        double energyDrift,
        double deepest,
        double deepestEnd,
        double meanEnd,
        double speedEnd,
        String note) {
    static final String HEADER = "scene,bodies,engine,steps,cpu_us_median,cpu_us_p99,energy_drift,deepest_overlap,"
            + "deepest_overlap_end,mean_overlap_end,rms_speed_end,note";

    static SceneRow failed(DiscScene scene, Contender engine, String note) {
        double none = Double.NaN;
        return new SceneRow(
                scene.name(), scene.discs().size(), engine, 0, none, none, none, none, none, none, none, note);
    }

    String csv() {
        return Csv.line(
                scene,
                String.valueOf(bodies),
                engine.label(),
                String.valueOf(steps),
                Cells.exact(micros),
                Cells.exact(p99Micros),
                Cells.exact(energyDrift),
                Cells.exact(deepest),
                Cells.exact(deepestEnd),
                Cells.exact(meanEnd),
                Cells.exact(speedEnd),
                note);
    }
}

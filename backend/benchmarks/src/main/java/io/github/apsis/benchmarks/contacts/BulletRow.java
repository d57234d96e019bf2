package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.discs.Contender;
import io.github.apsis.benchmarks.discs.DiscEngine;
import io.github.apsis.benchmarks.discs.DiscScene;
import io.github.apsis.benchmarks.discs.DiscScenes;
import io.github.apsis.benchmarks.discs.DiscScenes.Target;
import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.benchmarks.report.Csv;

/**
 * One line of {@code bullets.csv}: bullets from twenty places along their first tick.
 *
 * @param through how many went through the target
 * @param speedError of those that did not, the largest, relative to the speed that restitution leaves
 */
record BulletRow(String target, Contender engine, int shots, int through, double speedError) {
    static final String HEADER = "target,engine,shots,went_through,speed_error";

    private static final int SHOTS = 20;
    private static final int STEPS =
            120; // enough for an engine that lets nothing move by more than 2 lengths in a step

    static BulletRow of(Target target, Contender contender) {
        int through = 0;
        double worst = Double.NaN;
        String name = "";
        for (int shot = 0; shot < SHOTS; shot++) {
            DiscScene scene = DiscScenes.bullet(target, (double) shot / SHOTS);
            name = scene.name();
            DiscEngine engine = contender.run(scene);
            boolean behind = false;
            for (int step = 0; step < STEPS; step++) {
                engine.step();
                double edge = target == Target.BULLET ? engine.x(1) : 101;
                behind |= engine.x(0) > edge;
            }
            if (behind) {
                through++;
            } else {
                double left = DiscScenes.BULLET_RESTITUTION * DiscScenes.BULLET_SPEED;
                double error = Math.abs(engine.vx(0) + left) / left;
                worst = Double.isNaN(worst) ? error : Math.max(worst, error);
            }
        }
        return new BulletRow(name, contender, SHOTS, through, worst);
    }

    String csv() {
        return Csv.line(
                target, engine.label(), String.valueOf(shots), String.valueOf(through), Cells.exact(speedError));
    }
}

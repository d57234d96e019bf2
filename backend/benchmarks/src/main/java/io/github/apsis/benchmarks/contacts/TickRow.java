package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.CpuTime;
import io.github.apsis.benchmarks.discs.Contender;
import io.github.apsis.benchmarks.discs.DiscEngine;
import io.github.apsis.benchmarks.discs.DiscScene;
import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.benchmarks.report.Csv;
import io.github.apsis.engine.body.BodyDef;

/**
 * One line of {@code ticks.csv}: a case in an engine at one length of a tick.
 *
 * @param micros CPU time of a tick, the world's making shared among its ticks
 * @param timeError of the one bounce of a pair, time; NaN elsewhere
 * @param positionError at a sample, relative to the length scale
 * @param energyDrift relative, of elastic cases; NaN elsewhere
 */
record TickRow(
        String caseId,
        Contender engine,
        int ticksPerUnit,
        double micros,
        double timeError,
        double positionError,
        double energyDrift) {
    static final String HEADER = "case,engine,dt,cpu_us_per_tick,time_error,position_error,energy_drift";

    /**
     * Runs the case until a sample.
     *
     * @param sample which of them; its time must be a whole number of ticks
     */
    static TickRow of(ContactCase known, int sample, Contender contender, int ticksPerUnit) {
        DiscScene scene = known.scene(1.0 / ticksPerUnit);
        MotionSample truth = known.samples().get(sample);
        int ticks = (int) Math.rint(truth.time() * ticksPerUnit);
        double micros = CpuTime.bestMicros(() -> ran(scene, contender, ticks)) / ticks;
        DiscEngine engine = ran(scene, contender, ticks);
        double worst = 0;
        double energy = 0;
        double start = 0;
        for (int i = 0; i < known.bodies().size(); i++) {
            double[] state = truth.state()[i];
            worst = Math.max(worst, Math.hypot(engine.x(i) - state[0], engine.y(i) - state[1]));
            BodyDef body = known.bodies().get(i);
            start += 0.5 * body.mass() * (body.vx() * body.vx() + body.vy() * body.vy());
            energy += 0.5 * body.mass() * (engine.vx(i) * engine.vx(i) + engine.vy(i) * engine.vy(i));
        }
        return new TickRow(
                known.id(),
                contender,
                ticksPerUnit,
                micros,
                timeError(known, truth.time(), engine),
                worst / known.lengthScale(),
                known.isElastic() ? Math.abs(energy / start - 1) : Double.NaN);
    }

    private static DiscEngine ran(DiscScene scene, Contender contender, int ticks) {
        DiscEngine engine = contender.run(scene);
        for (int tick = 0; tick < ticks; tick++) {
            engine.step();
        }
        return engine;
    }

    /**
     * When the paths of a disc before and after its one bounce meet, the same for every engine: x₀ + v₀ t = x − v (T − t).
     */
    private static double timeError(ContactCase known, double end, DiscEngine engine) {
        if (known.events().size() != 1 || known.bodies().size() != 2) {
            return Double.NaN;
        }
        BodyDef body = known.bodies().get(0);
        double bent = body.vx() - engine.vx(0);
        double met = (engine.x(0) - body.x() - engine.vx(0) * end) / bent;
        return Math.abs(met - known.events().get(0).time());
    }

    String csv() {
        return Csv.line(
                caseId,
                engine.label(),
                "1/" + ticksPerUnit,
                Cells.exact(micros),
                Cells.exact(timeError),
                Cells.exact(positionError),
                Cells.exact(energyDrift));
    }
}

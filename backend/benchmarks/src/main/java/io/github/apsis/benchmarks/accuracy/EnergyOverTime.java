package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.benchmarks.report.Csv;
import io.github.apsis.engine.World;
import java.util.ArrayList;
import java.util.List;

/** The largest energy error until a moment, for moments evenly spread over a logarithmic axis: what drifts is seen to drift. */
final class EnergyOverTime {
    private static final int PER_DECADE = 60;

    private EnergyOverTime() {}

    /** One line of {@code energy.csv}. */
    record Row(String method, double dt, double tolerance, double time, double energyError) {
        static final String HEADER = "method,dt,tolerance,t,energy_error";

        static Row parse(String line) {
            List<String> cells = Csv.cells(line);
            if (cells.size() != 5) {
                throw new IllegalArgumentException("not a row of five cells: " + line);
            }
            return new Row(
                    cells.get(0),
                    cells.get(1).isEmpty() ? Double.NaN : Double.parseDouble(cells.get(1)),
                    cells.get(2).isEmpty() ? Double.NaN : Double.parseDouble(cells.get(2)),
                    Double.parseDouble(cells.get(3)),
                    Double.parseDouble(cells.get(4)));
        }

        String csv() {
            return Csv.line(
                    method,
                    Double.isNaN(dt) ? "" : Double.toString(dt),
                    Double.isNaN(tolerance) ? "" : Double.toString(tolerance),
                    Cells.plain(time),
                    Cells.exact(energyError));
        }

        String series() {
            return new OrbitRow("", method, dt, tolerance, 0, 0, 0, 0, "").label();
        }
    }

    /** Each method with a step that resolves a smooth orbit, and the adaptive one as tight as it goes. */
    static List<Setting> settings(NBodyCase orbit) {
        return List.of(
                Setting.fixed(Method.SEMI_IMPLICIT_EULER, Ladder.ROOM),
                Setting.fixed(Method.LEAPFROG, Ladder.ROOM),
                Setting.fixed(Method.YOSHIDA4, Ladder.ROOM),
                Setting.fixed(Method.PEFRL, Ladder.ROOM),
                Setting.fixed(Method.SYMPLECTIC8, 2 * Ladder.ROOM),
                Setting.adaptive(Ticks.longest(orbit), Tolerances.ADAPTIVE_DEFAULT));
    }

    /** Follows one case far beyond its last sample. */
    static List<Row> of(NBodyCase orbit, Setting setting, double end) {
        World world = orbit.world(setting);
        List<Row> rows = new ArrayList<>();
        double worst = 0;
        double next = 1;
        long ticks = Math.round(end / setting.dt());
        long stride = 1;
        while (world.tick() < ticks) {
            world.step();
            if (world.tick() % stride == 0 || world.time() >= next) {
                double energy = world.conserved().energy().orElse(Double.NaN);
                worst = Math.max(worst, Math.abs(energy - orbit.energy()) / orbit.energyScale());
            }
            if (world.time() >= next) {
                rows.add(new Row(setting.method().label(), setting.dt(), setting.tolerance(), world.time(), worst));
                next = world.time() * Math.pow(10, 1.0 / PER_DECADE);
                stride = 1 + world.tick() / 1000; // a thousand or two measurements in each decade
            }
        }
        return rows;
    }
}

package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.reference.Fraction;
import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.benchmarks.report.Csv;
import java.util.List;

/**
 * One line of {@code accuracy.csv}, of {@code rebound.csv} and of {@code solar-system.csv}: a case, a method, how fine it was,
 * what it cost, how far it strayed. NaN where there is no figure.
 */
record OrbitRow(
        String caseId,
        String method,
        double dt,
        double tolerance,
        double cpuMicrosPerUnit,
        double energyError,
        double spinError,
        double positionError,
        String status) {
    static final String HEADER = "case,method,dt,tolerance,cpu_us_per_unit,energy_error,L_error,position_error,status";
    private static final String PEER = "rebound-";

    /** A file that could not be used. */
    static OrbitRow without(String caseId, String status) {
        return failed(caseId, "", Double.NaN, Double.NaN, status);
    }

    static OrbitRow failed(String caseId, String method, double dt, double tolerance, String status) {
        return new OrbitRow(caseId, method, dt, tolerance, Double.NaN, Double.NaN, Double.NaN, Double.NaN, status);
    }

    static OrbitRow of(NBodyCase orbit, Setting setting, double cpu, OrbitErrors errors, String status) {
        OrbitErrors.AtSample last = errors.last();
        return new OrbitRow(
                orbit.id(),
                setting.method().label(),
                setting.dt(),
                setting.tolerance(),
                cpu,
                last.energyOf(setting.method()),
                last.spin(),
                last.position(),
                status);
    }

    static OrbitRow parse(String line) {
        List<String> cells = Csv.cells(line);
        if (cells.size() != 9) {
            throw new IllegalArgumentException("not a row of nine cells: " + line);
        }
        return new OrbitRow(
                cells.get(0),
                cells.get(1),
                number(cells.get(2)),
                number(cells.get(3)),
                number(cells.get(4)),
                number(cells.get(5)),
                number(cells.get(6)),
                number(cells.get(7)),
                cells.get(8));
    }

    private static double number(String cell) {
        return cell.isEmpty() ? Double.NaN : Double.parseDouble(cell);
    }

    String csv() {
        return Csv.line(
                caseId,
                method,
                Double.isNaN(dt) ? "" : Double.toString(dt),
                Double.isNaN(tolerance) ? "" : Double.toString(tolerance),
                Cells.exact(cpuMicrosPerUnit),
                Cells.exact(energyError),
                Cells.exact(spinError),
                Cells.exact(positionError),
                status);
    }

    boolean isPeer() {
        return method.startsWith(PEER);
    }

    /** Whether its errors say something. */
    boolean isMeasured() {
        return !Verdict.isFailed(status) && Double.isFinite(cpuMicrosPerUnit) && Double.isFinite(energyError);
    }

    /** {@code leapfrog 1/150}, {@code adaptive 1e-12}. */
    String label() {
        if (!Double.isNaN(tolerance)) {
            String ticked = Fraction.format(dt);
            return method + " " + "%.0e".formatted(tolerance) + (dt < 0.1 && !isPeer() ? " at " + ticked : "");
        }
        return Double.isNaN(dt) ? method : method + " " + Fraction.format(dt);
    }
}

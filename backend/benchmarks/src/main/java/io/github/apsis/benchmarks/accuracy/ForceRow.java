package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.benchmarks.report.Csv;
import io.github.apsis.engine.math.CompensatedSum;
import java.util.Arrays;
import java.util.List;

/**
 * One line of {@code force.csv}: the errors of one evaluation of the forces, and its price.
 *
 * @param theta opening angle; NaN for a direct sum
 * @param median of |a − a_ref| / |a_ref| over the bodies
 * @param p99 of the same
 * @param max of the same
 * @param rms of |a − a_ref|, against that of |a_ref|
 * @param netForce |Σ m a| / Σ m |a|
 * @param millis CPU time of an evaluation
 */
record ForceRow(
        String caseId,
        String solver,
        double theta,
        double median,
        double p99,
        double max,
        double rms,
        double netForce,
        double millis) {
    static final String HEADER = "case,solver,theta,median,p99,max,rms,net_force,ms";

    /** Measures accelerations against the true ones. */
    static ForceRow of(ForceCase truth, String solver, double theta, double[] ax, double[] ay, double millis) {
        int n = truth.count();
        double[] relative = new double[n];
        double squares = 0;
        double trueSquares = 0;
        var netX = new CompensatedSum(); // plain sums of 10 000 forces are off by more than the forces are
        var netY = new CompensatedSum();
        double absolute = 0;
        for (int i = 0; i < n; i++) {
            double error = Math.hypot(ax[i] - truth.ax()[i], ay[i] - truth.ay()[i]);
            double size = Math.hypot(truth.ax()[i], truth.ay()[i]);
            relative[i] = error / size;
            squares += error * error;
            trueSquares += size * size;
            netX.add(truth.m()[i] * ax[i]);
            netY.add(truth.m()[i] * ay[i]);
            absolute += truth.m()[i] * Math.hypot(ax[i], ay[i]);
        }
        Arrays.sort(relative);
        return new ForceRow(
                truth.id(),
                solver,
                theta,
                relative[n / 2],
                relative[Math.min(n - 1, (int) Math.ceil(0.99 * n) - 1)],
                relative[n - 1],
                Math.sqrt(squares / trueSquares),
                Math.hypot(netX.value(), netY.value()) / absolute,
                millis);
    }

    static ForceRow parse(String line) {
        List<String> cells = Csv.cells(line);
        if (cells.size() != 9) {
            throw new IllegalArgumentException("not a row of nine cells: " + line);
        }
        double[] numbers = cells.stream()
                .skip(2)
                .mapToDouble(cell -> cell.isEmpty() ? Double.NaN : Double.parseDouble(cell))
                .toArray();
        return new ForceRow(
                cells.get(0),
                cells.get(1),
                numbers[0],
                numbers[1],
                numbers[2],
                numbers[3],
                numbers[4],
                numbers[5],
                numbers[6]);
    }

    String csv() {
        return Csv.line(
                caseId,
                solver,
                Double.isNaN(theta) ? "" : Cells.plain(theta),
                Cells.exact(median),
                Cells.exact(p99),
                Cells.exact(max),
                Cells.exact(rms),
                Cells.exact(netForce),
                Cells.exact(millis));
    }
}

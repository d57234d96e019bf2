package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.report.Cells;
import io.github.apsis.benchmarks.report.Csv;
import java.util.List;

/**
 * One line of {@code speed.csv}: a scene of some size in an engine, and one of the errors that it had in the same run.
 *
 * @param n bodies
 * @param threads that step the world
 * @param jdk its version; empty for what does not run in a JVM
 * @param msPerStep CPU time of the stepping thread, the median of the batches; on several threads time by the clock
 * @param p99Ms by the clock: 99 of 100 steps take no longer
 * @param allocBytesPerStep by the stepping thread, in the second half of the measured steps
 * @param errorKind what is wrong, in which measure
 * @param error how much of it
 */
record SpeedRow(
        String scene,
        String engine,
        int n,
        int threads,
        String jdk,
        double msPerStep,
        double p99Ms,
        double allocBytesPerStep,
        String errorKind,
        double error) {
    static final String HEADER = "scene,engine,n,threads,jdk,ms_per_step,p99_ms,alloc_bytes_per_step,error_kind,error";

    /** The version that is compared: 17 of {@code 17.0.15}. */
    String jdkFeature() {
        return jdk.replaceFirst("\\..*", "");
    }

    /** The engine, and how many threads where there are several. */
    String contender() {
        return threads == 1 ? engine : engine + ", " + threads + " threads";
    }

    String csv() {
        return Csv.line(
                scene,
                engine,
                String.valueOf(n),
                String.valueOf(threads),
                jdk,
                Cells.exact(msPerStep),
                Cells.exact(p99Ms),
                Double.isNaN(allocBytesPerStep) ? "" : Cells.plain(allocBytesPerStep),
                errorKind,
                Cells.exact(error));
    }

    static SpeedRow parse(String line) {
        List<String> cells = Csv.cells(line);
        if (cells.size() != 10) {
            throw new IllegalArgumentException("not a row of ten cells: " + line);
        }
        return new SpeedRow(
                cells.get(0),
                cells.get(1),
                Integer.parseInt(cells.get(2)),
                Integer.parseInt(cells.get(3)),
                cells.get(4),
                number(cells.get(5)),
                number(cells.get(6)),
                number(cells.get(7)),
                cells.get(8),
                number(cells.get(9)));
    }

    private static double number(String cell) {
        return cell.isEmpty() ? Double.NaN : Double.parseDouble(cell);
    }
}

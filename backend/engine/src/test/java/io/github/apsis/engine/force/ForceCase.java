package io.github.apsis.engine.force;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.CompensatedSum;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;

/** Bodies with known accelerations for G = 1, read from {@code src/test/resources/reference}, and how far a law is off. */
final class ForceCase {
    private final double[][] rows; // m, x, y, ax, ay and, for 1000 bodies, the softened ax, ay

    private ForceCase(double[][] rows) {
        this.rows = rows;
    }

    static ForceCase of(String id) {
        var in = Objects.requireNonNull(ForceCase.class.getResourceAsStream("/reference/force-" + id + ".csv"));
        try (var reader = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
            List<String> lines = reader.lines().skip(1).toList();
            return new ForceCase(lines.stream().map(ForceCase::numbers).toArray(double[][]::new));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static double[] numbers(String line) {
        return Arrays.stream(line.split(",")).mapToDouble(Double::parseDouble).toArray();
    }

    Bodies bodies() {
        var bodies = new Bodies();
        for (double[] row : rows) {
            bodies.add(BodyDef.planet(row[1], row[2], row[0], 0));
        }
        return bodies;
    }

    /** How far the law is off. */
    Errors errorsOf(ForceLaw law) {
        return errorsOf(law, 3);
    }

    /** How far the law is off from the softened reference. */
    Errors errorsOfSoftened(ForceLaw law) {
        return errorsOf(law, 5);
    }

    private Errors errorsOf(ForceLaw law, int column) {
        Bodies bodies = bodies();
        law.apply(bodies);
        double[] relative = new double[rows.length];
        double squares = 0;
        double squaresOfTruth = 0;
        for (int i = 0; i < rows.length; i++) {
            double truth = Math.hypot(rows[i][column], rows[i][column + 1]);
            double off = Math.hypot(bodies.ax(i) - rows[i][column], bodies.ay(i) - rows[i][column + 1]);
            relative[i] = off / truth;
            squares += off * off;
            squaresOfTruth += truth * truth;
        }
        Arrays.sort(relative);
        return new Errors(
                relative[rows.length / 2],
                relative[rows.length * 99 / 100],
                relative[rows.length - 1],
                Math.sqrt(squares / squaresOfTruth),
                netForce(bodies));
    }

    /** |Σ m a| / Σ m |a|, summed so that the measurement is not the error. */
    static double netForce(Bodies bodies) {
        var fx = new CompensatedSum();
        var fy = new CompensatedSum();
        double scale = 0;
        for (int i = 0; i < bodies.count(); i++) {
            fx.add(bodies.mass(i) * bodies.ax(i));
            fy.add(bodies.mass(i) * bodies.ay(i));
            scale += bodies.mass(i) * Math.hypot(bodies.ax(i), bodies.ay(i));
        }
        return Math.hypot(fx.value(), fy.value()) / scale;
    }

    /** Relative errors over all bodies, rms |Δa| / rms |a|, and |Σ m a| / Σ m |a|. */
    record Errors(double median, double percentile99, double worst, double rms, double netForce) {}
}

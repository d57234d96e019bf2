package io.github.apsis.benchmarks.speed;

import java.util.List;
import java.util.OptionalDouble;

/**
 * The exponent k of cost ∝ n^k, by least squares in the logarithms:
 *
 * <pre>
 *   k = Σ (ln n − ⟨ln n⟩)(ln t − ⟨ln t⟩) / Σ (ln n − ⟨ln n⟩)²
 * </pre>
 */
final class PowerLaw {
    /** What a tick costs with few bodies is not what it costs per body. */
    static final int FROM = 1000;

    private PowerLaw() {}

    /** Of pairs of n and cost with n of {@link #FROM} at least; empty where there are not two sizes of them. */
    static OptionalDouble exponent(List<double[]> points) {
        double[][] logs = points.stream()
                .filter(point -> point[0] >= FROM && point[1] > 0)
                .map(point -> new double[] {Math.log(point[0]), Math.log(point[1])})
                .toArray(double[][]::new);
        double meanX = mean(logs, 0);
        double meanY = mean(logs, 1);
        double above = 0;
        double below = 0;
        for (double[] log : logs) {
            above += (log[0] - meanX) * (log[1] - meanY);
            below += (log[0] - meanX) * (log[0] - meanX);
        }
        return below > 0 ? OptionalDouble.of(above / below) : OptionalDouble.empty();
    }

    private static double mean(double[][] logs, int axis) {
        double sum = 0;
        for (double[] log : logs) {
            sum += log[axis];
        }
        return sum / logs.length;
    }
}

package io.github.apsis.benchmarks.speed;

import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.math.CompensatedSum;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;

/**
 * Accelerations against a compensated direct sum, of all bodies or, where that takes minutes, of every k-th.
 *
 * <pre>
 *   force-rms = √(Σ|a − a_ref|² / Σ|a_ref|²)      force-median, force-worst: of |a − a_ref| / |a_ref|
 * </pre>
 */
final class ForceCheck {
    private static final long MOST_PAIRS = 200_000_000; // seconds
    private static final int FEWEST = 100;

    private final WorldSnapshot now;
    private final double g;
    private final double softeningSquared;
    private final CompensatedSum ax = new CompensatedSum();
    private final CompensatedSum ay = new CompensatedSum();
    private double squares;
    private double trueSquares;

    private ForceCheck(WorldSnapshot now, WorldSpec spec) {
        this.now = now;
        this.g = spec.gravity();
        this.softeningSquared = spec.softening() * spec.softening();
    }

    /** Of those bodies that gravity alone accelerates. */
    static List<Finding> of(WorldSnapshot now, WorldSpec spec, IntPredicate isFree) {
        return new ForceCheck(now, spec)
                .findings(IntStream.range(0, now.count()).filter(isFree).toArray());
    }

    private List<Finding> findings(int[] bodies) {
        int sample = (int) Math.min(bodies.length, Math.max(FEWEST, MOST_PAIRS / now.count()));
        double[] errors = new double[sample];
        for (int k = 0; k < sample; k++) {
            errors[k] = error(bodies[(int) ((long) k * bodies.length / sample)]);
        }
        Arrays.sort(errors);
        return List.of(
                new Finding("force-rms", Math.sqrt(squares / trueSquares)),
                new Finding("force-median", errors[sample / 2]),
                new Finding("force-worst", errors[sample - 1]));
    }

    private double error(int i) {
        ax.clear();
        ay.clear();
        for (int j = 0; j < now.count(); j++) {
            double dx = now.x(j) - now.x(i);
            double dy = now.y(j) - now.y(i);
            double d2 = dx * dx + dy * dy + softeningSquared;
            if (j != i && d2 > 0) {
                double pull = g * now.mass(j) / (d2 * Math.sqrt(d2));
                ax.add(pull * dx);
                ay.add(pull * dy);
            }
        }
        double offX = now.ax(i) - ax.value();
        double offY = now.ay(i) - ay.value();
        double off = offX * offX + offY * offY;
        double truth = ax.value() * ax.value() + ay.value() * ay.value();
        squares += off;
        trueSquares += truth;
        return off == 0 ? 0 : Math.sqrt(off / truth);
    }
}

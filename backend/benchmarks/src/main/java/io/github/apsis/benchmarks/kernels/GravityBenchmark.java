package io.github.apsis.benchmarks.kernels;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.force.DirectGravity;
import io.github.apsis.engine.force.TreeGravity;
import io.github.apsis.engine.math.Rng;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** One evaluation of gravity in a disc of equal masses. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@SuppressWarnings("NullAway.Init") // set by JMH before each run
public class GravityBenchmark {
    private static final double RADIUS = 1000;
    private static final double SOFTENING = 1;

    @Param({"100", "1000", "3000"})
    private int bodies;

    private Bodies disc;
    private DirectGravity direct;
    private TreeGravity tree;

    @Setup
    public void strewMasses() {
        disc = new Bodies();
        Rng rng = new Rng(12345);
        for (int i = 0; i < bodies; i++) {
            double r = RADIUS * Math.sqrt(rng.nextDouble());
            double angle = rng.between(0, 2 * Math.PI);
            disc.add(BodyDef.planet(r * StrictMath.cos(angle), r * StrictMath.sin(angle), 1, 0));
        }
        direct = new DirectGravity(1, SOFTENING);
        tree = new TreeGravity(1, SOFTENING, 0.5);
    }

    @Benchmark
    public void everyPair() {
        direct.apply(disc);
    }

    @Benchmark
    public void tree() {
        tree.apply(disc);
    }
}

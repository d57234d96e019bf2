package io.github.apsis.benchmarks.kernels;

import io.github.apsis.engine.math.Rng;
import io.github.apsis.engine.spatial.Quadtree;
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

/** The quadtree over equal boxes, a fifth of the area: made, and asked for the neighbours of each. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@SuppressWarnings("NullAway.Init") // set by JMH before each run
public class QuadtreeBenchmark {
    private static final double RADIUS = 2;
    private static final double DENSITY = 0.2; // share of the area

    @Param({"250", "5000", "100000"})
    private int boxes;

    private double[] x;
    private double[] y;
    private Quadtree tree;

    @Setup
    public void strewBoxes() {
        x = new double[boxes];
        y = new double[boxes];
        double side = Math.sqrt(boxes * Math.PI * RADIUS * RADIUS / DENSITY);
        Rng rng = new Rng(12345);
        for (int i = 0; i < boxes; i++) {
            x[i] = rng.between(0, side);
            y[i] = rng.between(0, side);
        }
        tree = new Quadtree();
        build();
    }

    @Benchmark
    public void build() {
        tree.begin(boxes);
        for (int i = 0; i < boxes; i++) {
            tree.set(i, x[i] - RADIUS, y[i] - RADIUS, x[i] + RADIUS, y[i] + RADIUS);
        }
        tree.build();
    }

    @Benchmark
    public int queryAll() {
        int hits = 0;
        for (int i = 0; i < boxes; i++) {
            hits += tree.query(x[i] - RADIUS, y[i] - RADIUS, x[i] + RADIUS, y[i] + RADIUS);
        }
        return hits;
    }
}

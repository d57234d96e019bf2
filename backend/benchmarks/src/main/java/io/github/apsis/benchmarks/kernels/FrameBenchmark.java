package io.github.apsis.benchmarks.kernels;

import io.github.apsis.benchmarks.speed.RoomFrames;
import io.github.apsis.protocol.Frame;
import io.github.apsis.protocol.json.FrameEncoder;
import java.util.List;
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

/** A frame of the public room as text. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
@SuppressWarnings("NullAway.Init") // set by JMH before each run
public class FrameBenchmark {
    @Param({"250", "1000"})
    private int bodies;

    private final FrameEncoder encoder = new FrameEncoder();
    private List<Frame> frames;
    private int next;

    @Setup
    public void runRoom() {
        frames = RoomFrames.of(bodies, 4);
    }

    @Benchmark
    public String encode() {
        next = (next + 1) % frames.size();
        return encoder.encode(frames.get(next));
    }
}

package io.github.apsis.benchmarks.speed;

import java.util.List;
import java.util.stream.Stream;

/** The cost of a step and the errors of the same run. */
record Measured(StepCost cost, List<Finding> findings) {
    Stream<SpeedRow> rows(String scene, String engine, int n, int threads) {
        String jdk = System.getProperty("java.version");
        return findings.stream()
                .map(finding -> new SpeedRow(
                        scene,
                        engine,
                        n,
                        threads,
                        jdk,
                        cost.ms(),
                        cost.p99Ms(),
                        cost.bytes(),
                        finding.kind(),
                        finding.value()));
    }
}

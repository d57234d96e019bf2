package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.discs.Contender;
import io.github.apsis.benchmarks.discs.DiscEngine;
import io.github.apsis.benchmarks.discs.DiscOverlaps;
import io.github.apsis.benchmarks.discs.DiscScene;
import java.util.ArrayList;
import java.util.List;

/** A scene of discs in an engine: overlaps in radii, and where all energy must stay, its drift. */
final class DiscCourse implements Course {
    private final DiscScene scene;
    private final DiscEngine engine;
    private final double energyAtStart;
    private double deepest;

    DiscCourse(DiscScene scene, Contender contender) {
        this.scene = scene;
        this.engine = contender.run(scene);
        this.energyAtStart = scene.kineticEnergy(engine);
    }

    @Override
    public void step() {
        engine.step();
    }

    @Override
    public void look() {
        deepest = Math.max(deepest, DiscOverlaps.of(scene, engine).deepest());
    }

    @Override
    public List<Finding> findings() {
        List<Finding> findings = new ArrayList<>();
        if (scene.restitution() == 1) {
            double drift = scene.kineticEnergy(engine) / energyAtStart - 1;
            findings.add(new Finding("energy-drift", Math.abs(drift)));
        }
        findings.add(new Finding("overlap", deepest));
        if (scene.restitution() < 1) {
            DiscOverlaps end = DiscOverlaps.of(scene, engine);
            findings.add(new Finding("overlap-end", end.deepest()));
            findings.add(new Finding("overlap-mean-end", end.mean()));
            findings.add(new Finding("kinetic-energy-end", scene.kineticEnergy(engine)));
            findings.add(new Finding("fastest-end", scene.fastest(engine)));
        }
        return findings;
    }
}

package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.CpuTime;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.WorldSpec.Integration;
import io.github.apsis.engine.body.BodyDef;

/** The accelerations of a force case by the engine's solvers, and their price. */
final class ForceRun {
    // Nobody gets anywhere in such a tick, but each one evaluates the forces once; the rest of it is below 1 % from
    // 1000 bodies.
    private static final double NO_TIME = 1e-18;

    private final ForceCase bodies;

    ForceRun(ForceCase bodies) {
        this.bodies = bodies;
    }

    ForceRow direct() {
        return measure("direct", Double.NaN, spec());
    }

    ForceRow tree(double theta) {
        return measure("tree", theta, spec().tree(theta));
    }

    private WorldSpec.Builder spec() {
        return WorldSpec.builder()
                .gravity(bodies.g())
                .integration(Integration.SEMI_IMPLICIT_EULER)
                .dt(NO_TIME);
    }

    private ForceRow measure(String solver, double theta, WorldSpec.Builder spec) {
        World world = new World(spec.maxBodies(bodies.count()).build());
        for (int i = 0; i < bodies.count(); i++) {
            world.add(BodyDef.planet(bodies.x()[i], bodies.y()[i], bodies.m()[i], 0));
        }
        WorldSnapshot start = world.snapshot();
        double[] ax = new double[bodies.count()];
        double[] ay = new double[bodies.count()];
        for (int i = 0; i < ax.length; i++) {
            ax[i] = start.ax(i);
            ay[i] = start.ay(i);
        }
        return ForceRow.of(bodies, solver, theta, ax, ay, CpuTime.medianMicros(world::step) * 1e-3);
    }
}

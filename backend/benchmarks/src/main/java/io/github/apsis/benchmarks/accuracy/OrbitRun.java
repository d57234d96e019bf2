package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.CpuTime;
import io.github.apsis.engine.World;
import io.github.apsis.engine.diagnostics.Conserved;
import java.util.ArrayList;
import java.util.List;

/**
 * One case run with one setting and measured on the way. Errors are measured and time is taken in worlds of their own, so that
 * neither disturbs the other.
 */
final class OrbitRun {
    private static final long MOMENTS =
            40_000; // enough to meet every pericentre of 1000 orbits; a fraction of a second

    private static final long WARM_TICKS = 10_000;

    private final NBodyCase orbit;
    private final Setting setting;

    OrbitRun(NBodyCase orbit, Setting setting) {
        this.orbit = orbit;
        this.setting = setting;
    }

    /** Runs to the last sample, measuring conserved quantities at ticks spread over the run and positions at samples. */
    OrbitErrors errors() {
        World world = orbit.world(setting);
        var watch = new Watch(world);
        List<OrbitErrors.AtSample> samples = new ArrayList<>();
        long stride = 1 + Math.round(orbit.end() / setting.dt()) / MOMENTS;
        long unit = Ticks.until(1, setting.dt()); // ticks; 0 when a unit of time is no whole number of them
        for (Sample sample : orbit.samples()) {
            long tick = Ticks.until(sample.time(), setting.dt());
            if (tick == 0) {
                continue; // the last one falls on a tick: the setting was chosen so
            }
            while (world.tick() < tick) {
                world.step();
                if (unit > 0 && world.tick() % unit == 0) {
                    watch.measureAtUnit(world);
                } else if (world.tick() % stride == 0) {
                    watch.measure(world);
                }
            }
            watch.measure(world);
            double position = sample.positionError(world.snapshot()) / orbit.lengthScale();
            samples.add(new OrbitErrors.AtSample(
                    sample.time(), watch.energy, unit > 0 ? watch.energyAtUnits : Double.NaN, watch.spin, position));
        }
        return new OrbitErrors(
                samples, watch.momentum, world.count() < orbit.bodies().size());
    }

    /** CPU time for one unit of simulated time, µs. */
    double cpuMicrosPerUnit(double until) {
        return CpuTime.bestMicros(() -> run(ticks(until))) / (ticks(until) * setting.dt());
    }

    /** Lets the compiler see the method before anything is timed. */
    void warmUp(long nanos) {
        CpuTime.warmUp(() -> run(Math.min(WARM_TICKS, ticks(orbit.end()))), nanos);
    }

    private void run(long ticks) {
        World world = orbit.world(setting);
        for (long i = 0; i < ticks; i++) {
            world.step();
        }
    }

    private long ticks(double until) {
        return Math.max(1, (long) Math.floor(until / setting.dt() * (1 + 1e-12)));
    }

    /** The largest errors of conserved quantities so far. */
    private final class Watch {
        private final double momentumX;
        private final double momentumY;
        private double momentumScale;
        private double energy;
        private double energyAtUnits;
        private double spin;
        private double momentum;

        private Watch(World world) {
            Conserved start = world.conserved();
            momentumX = start.momentumX();
            momentumY = start.momentumY();
            momentumScale = start.momentumScale();
        }

        private void measureAtUnit(World world) {
            energyAtUnits = Math.max(energyAtUnits, measure(world));
        }

        /** Measures everything, and returns the energy error of this moment. */
        private double measure(World world) {
            Conserved now = world.conserved();
            double energyNow = Math.abs(now.energy().orElse(Double.NaN) - orbit.energy()) / orbit.energyScale();
            energy = Math.max(energy, energyNow);
            spin = Math.max(spin, Math.abs(now.angularMomentum() - orbit.spin()) / orbit.spinScale());
            momentumScale = Math.max(momentumScale, now.momentumScale());
            double dx = now.momentumX() - momentumX;
            double dy = now.momentumY() - momentumY;
            momentum = Math.max(momentum, Math.hypot(dx, dy) / Math.max(momentumScale, Double.MIN_NORMAL));
            return energyNow;
        }
    }
}

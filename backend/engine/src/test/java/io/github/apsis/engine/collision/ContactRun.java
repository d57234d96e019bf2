package io.github.apsis.engine.collision;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.diagnostics.Conserved;

/**
 * One second of a random scene, looked at after each of its 150 ticks.
 *
 * @param momentumError the largest |p − p₀ − J| of all ticks, as a share of all momentum that was under way or came from outside
 * @param energyGain the largest E − E₀ of all ticks, as a share of {@code scale}; below 0 when all ticks had less
 * @param energyGainOverWork the same of E − E₀ − W, W the work in the books
 * @param energyError the largest |E − E₀ − W|, as the same share
 * @param angularError the largest |L − L₀ − M| of all ticks, as a share of Σ m|r||v|; NaN in a periodic world
 * @param deepest overlap of a pair of bodies with mass at the end, radii of the smaller
 * @param deepestInWall of a body with mass at the end, radii
 * @param deepestEver of pairs and walls after any tick
 * @param isFinite whether all bodies are still there, with numbers for places and velocities
 */
record ContactRun(
        RandomContactScene scene,
        double momentumError,
        double energyGain,
        double energyGainOverWork,
        double energyError,
        double angularError,
        double deepest,
        double deepestInWall,
        double deepestEver,
        boolean isFinite,
        long hash) {
    static final int TICKS = 150;

    static ContactRun of(RandomContactScene scene) {
        try {
            return measured(scene);
        } catch (IllegalStateException nowhere) { // what a world throws when a body left the numbers
            double nan = Double.NaN;
            return new ContactRun(scene, nan, nan, nan, nan, nan, nan, nan, nan, false, 0);
        }
    }

    private static ContactRun measured(RandomContactScene scene) {
        World world = scene.world();
        Conserved start = world.conserved();
        Scale scale = new Scale(scene);
        scale.look(world.snapshot());
        double momentum = 0;
        double gain = Double.NEGATIVE_INFINITY;
        double gainOverWork = Double.NEGATIVE_INFINITY;
        double energy = 0;
        double angular = 0;
        double deepestEver = 0;
        for (int tick = 0; tick < TICKS; tick++) {
            world.step();
            WorldSnapshot now = world.snapshot();
            scale.look(now);
            Conserved c = world.conserved();
            momentum = Math.max(
                    momentum,
                    Math.hypot(
                            c.momentumX() - start.momentumX() - c.booked().momentumX(),
                            c.momentumY() - start.momentumY() - c.booked().momentumY()));
            double change = c.energy().orElse(0) - start.energy().orElse(0);
            gain = Math.max(gain, change);
            gainOverWork = Math.max(gainOverWork, change - c.booked().energy());
            energy = Math.max(energy, Math.abs(change - c.booked().energy()));
            angular = Math.max(
                    angular,
                    Math.abs(c.angularMomentum()
                            - start.angularMomentum()
                            - c.booked().angularMomentum()));
            deepestEver = Math.max(deepestEver, deepest(scene, now));
            deepestEver = Math.max(deepestEver, deepestInWall(scene, now));
        }
        WorldSnapshot end = world.snapshot();
        return new ContactRun(
                scene,
                share(momentum, scale.momentum),
                scene.hasEnergy() ? share(gain, scale.energy) : Double.NaN,
                scene.hasEnergy() ? share(gainOverWork, scale.energy) : Double.NaN,
                scene.hasEnergy() ? share(energy, scale.energy) : Double.NaN,
                scene.isPeriodic() ? Double.NaN : share(angular, scale.angular),
                deepest(scene, end),
                deepestInWall(scene, end),
                deepestEver,
                isFinite(end) && world.departures().isEmpty(),
                world.stateHash());
    }

    /** The state at the end of a second run, which nobody looks at. */
    static long hashAgain(RandomContactScene scene) {
        World world = scene.world();
        for (int tick = 0; tick < TICKS; tick++) {
            world.step();
        }
        return world.stateHash();
    }

    boolean bornApart() {
        return scene.bornApart();
    }

    private static double deepest(RandomContactScene scene, WorldSnapshot now) {
        return Depth.ofPairs(now, scene.spec().boundary(), scene::isFixed, scene::canBeSqueezed);
    }

    private static double deepestInWall(RandomContactScene scene, WorldSnapshot now) {
        return Depth.inWalls(now, scene.spec().boundary(), scene::canBeSqueezed);
    }

    private static double share(double error, double scale) {
        return error == 0 ? 0 : error / scale;
    }

    private static boolean isFinite(WorldSnapshot now) {
        double sum = 0;
        for (int i = 0; i < now.count(); i++) {
            sum += 0 * (now.x(i) + now.y(i) + now.vx(i) + now.vy(i)); // NaN for what is no number
        }
        return sum == 0;
    }

    /** The largest amounts that were there to be wrong about: sums of magnitudes, which do not cancel. */
    private static final class Scale {
        private final RandomContactScene scene;
        private double energy;
        private double momentum;
        private double angular;

        private Scale(RandomContactScene scene) {
            this.scene = scene;
        }

        private void look(WorldSnapshot now) {
            double e = scene.surfacePotential();
            double p = scene.surfacePull() * now.time();
            double l = 0;
            for (int i = 0; i < now.count(); i++) {
                double m = Math.max(now.mass(i), 1e-150); // as much as the engine takes a body without mass for
                double speed = Math.hypot(now.vx(i), now.vy(i));
                double r = Math.hypot(now.x(i), now.y(i));
                double fieldImpulse = m * scene.field() * now.time();
                e += 0.5 * m * speed * speed + m * scene.field() * r;
                p += m * speed + fieldImpulse;
                l += (m * speed + fieldImpulse) * (r + now.radius(i));
            }
            energy = Math.max(energy, e);
            momentum = Math.max(momentum, p);
            angular = Math.max(angular, l);
        }
    }
}

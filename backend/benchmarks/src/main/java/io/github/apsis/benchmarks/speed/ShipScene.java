package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.Overlaps;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import java.util.List;

/** Ships that wander in a box and get out of each other's way. */
final class ShipScene implements SpeedScene {
    private static final double SPACING = 75; // length; a square of this side to each ship
    private static final double PLAY = 50; // of a ship in its square at the start
    private static final ShipLimits LIMITS = new ShipLimits(120, 2400);
    private static final double MASS = 12;
    private static final double RADIUS = 7;

    @Override
    public String name() {
        return "ships";
    }

    @Override
    public String description() {
        return "Ships of radius 7 that wander at up to 120 in a closed box, a square of side 75 to each, and avoid each other."
                + " `bounces-per-ship-minute`: contacts that they could not avoid, walls included; `overlap`: the deepest"
                + " at the end, radii.";
    }

    @Override
    public boolean usesThreads() {
        return true;
    }

    @Override
    public void run(Bench bench) {
        int[] brief = {10, 100, 1000};
        for (int n : bench.choose(new int[] {10, 50}, brief, new int[] {10, 100, 1000, 10_000})) {
            Trial trial = bench.choose(
                    new Trial(100, 20, 40, 20, 5),
                    new Trial(300, 150, 300, 30, 20),
                    new Trial(2000, 150, n <= 1000 ? 1500 : 150, 30, 60));
            bench.measure(name(), "apsis", n, trial, () -> new Swarm(world(bench, n)));
        }
    }

    private static World world(Bench bench, int count) {
        int columns = (int) Math.ceil(Math.sqrt(count));
        double side = columns * SPACING;
        World world = new World(bench.spec(WorldSpec.builder()
                .contacts(0.8)
                .walls(new Aabb(0, 0, side, side), 0.8)
                .seed(1)));
        Rng rng = new Rng(1);
        for (int i = 0; i < count; i++) {
            double x = (i % columns + 0.5) * SPACING + rng.between(-PLAY / 2, PLAY / 2);
            double y = (i / columns + 0.5) * SPACING + rng.between(-PLAY / 2, PLAY / 2);
            world.add(BodyDef.ship(x, y, MASS, RADIUS, LIMITS).moving(rng.between(-60, 60), rng.between(-60, 60)));
        }
        return world;
    }

    private static final class Swarm implements Course {
        private final World world;
        private long bounces;

        Swarm(World world) {
            this.world = world;
            world.onBounce((time, first, second, closingSpeed, impulse) -> bounces++);
        }

        @Override
        public void step() {
            world.step();
        }

        @Override
        public List<Finding> findings() {
            double shipMinutes = world.count() * world.time() / 60;
            return List.of(
                    new Finding("bounces-per-ship-minute", bounces / shipMinutes),
                    new Finding(
                            "overlap",
                            Overlaps.of(world.snapshot(), world.spec().boundary())
                                    .deepest()));
        }

        @Override
        public void end() {
            world.close();
        }
    }
}

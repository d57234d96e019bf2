package io.github.apsis.benchmarks.speed;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import java.util.List;

/** Two ships to an asteroid, in a box: what a ship avoids does not avoid it. */
final class FleetScene implements SpeedScene {
    private static final double AREA = 7200; // to each ship, length²
    private static final double RADIUS = 8;
    private static final ShipLimits LIMITS = new ShipLimits(120, 200);
    private static final double CRUISE = 72; // at the start
    private static final double LARGEST_ROCK = 20;
    private static final double FASTEST_ROCK = 60;

    @Override
    public String name() {
        return "fleet";
    }

    @Override
    public String description() {
        return "Ships of radius 8, 120 units/s and 200 units/s² that wander among half as many drifting asteroids of 10 to 20, 7200 of area"
                + " to each ship, in a closed box; `n` counts both. `bounces-per-ship-minute`: contacts of ships, walls included.";
    }

    @Override
    public boolean usesThreads() {
        return true;
    }

    @Override
    public void run(Bench bench) {
        int[] sizes = {300, 3000};
        for (int n : bench.choose(new int[] {30}, sizes, sizes)) {
            Trial trial = bench.choose(
                    new Trial(100, 20, 40, 20, 5),
                    new Trial(500, 300, 600, 30, 30),
                    new Trial(2000, 300, 1500, 30, 60));
            bench.measure(name(), "apsis", n, trial, () -> new Fleet(world(bench, n)));
        }
    }

    private static World world(Bench bench, int count) {
        int columns = (int) Math.ceil(Math.sqrt(count));
        double square = Math.sqrt(AREA * 2 / 3);
        double side = columns * square;
        World world = new World(bench.spec(WorldSpec.builder()
                .contacts(0.8)
                .walls(new Aabb(0, 0, side, side), 0.8)
                .seed(1)));
        Rng rng = new Rng(1);
        for (int i = 0; i < count; i++) {
            double x = (i % columns + 0.5) * square + rng.between(-5, 5);
            double y = (i / columns + 0.5) * square + rng.between(-5, 5);
            double r = rng.between(LARGEST_ROCK / 2, LARGEST_ROCK);
            boolean isRock = i % 3 == 2;
            double speed = isRock ? FASTEST_ROCK : CRUISE;
            BodyDef body = isRock ? BodyDef.asteroid(x, y, r * r, r) : BodyDef.ship(x, y, 1, RADIUS, LIMITS);
            double share = Math.sqrt(0.5);
            world.add(body.moving(rng.between(-share, share) * speed, rng.between(-share, share) * speed));
        }
        return world;
    }

    private static final class Fleet implements Course {
        private final World world;
        private final int ships;
        private long bounces;

        Fleet(World world) {
            this.world = world;
            ships = world.count() - world.count() / 3;
            world.onBounce(
                    (time, first, second, closingSpeed, impulse) -> bounces += isShip(first) || isShip(second) ? 1 : 0);
        }

        private static boolean isShip(long id) {
            return id > 0 && id % 3 != 0; // ids begin with 1, every third body is a rock, and walls are negative
        }

        @Override
        public void step() {
            world.step();
        }

        @Override
        public List<Finding> findings() {
            return List.of(new Finding("bounces-per-ship-minute", bounces / (ships * world.time() / 60)));
        }

        @Override
        public void end() {
            world.close();
        }
    }
}

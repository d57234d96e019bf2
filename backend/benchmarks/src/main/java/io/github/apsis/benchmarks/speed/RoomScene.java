package io.github.apsis.benchmarks.speed;

import io.github.apsis.engine.World;
import io.github.apsis.scenes.Scene;
import io.github.apsis.scenes.SceneCatalogue;
import java.util.List;
import java.util.stream.LongStream;

/** The room that everybody sees first, alone or with many beside it. */
final class RoomScene implements SpeedScene {
    private static final String SCENE = "belt-and-swarm";
    private static final int ROOMS = 100;

    private final boolean crowded;

    private RoomScene(boolean crowded) {
        this.crowded = crowded;
    }

    /** One room, in several sizes. */
    static RoomScene alone() {
        return new RoomScene(false);
    }

    /** A hundred rooms that tick in turn on one thread. */
    static RoomScene hundred() {
        return new RoomScene(true);
    }

    @Override
    public String name() {
        return crowded ? "hundred-rooms" : "default-tick";
    }

    @Override
    public String description() {
        return crowded
                ? "A hundred rooms of 250 bodies that tick in turn on one thread: the cost of a tick of one room when the others have"
                        + " had the caches meanwhile. Errors as above, the worst of all rooms."
                : "The tick of the public room: a planet, moons, a belt of asteroids and a swarm of ships, with gravity, contacts,"
                        + " walls and avoidance. `energy-drift`: (E − E₀ − W) / (K₀ + |U₀| + |W|), the largest seen; W is the booked work of engines, contacts and walls."
                        + " `overlap`: the deepest seen, in radii of the smaller.";
    }

    @Override
    public void run(Bench bench) {
        if (crowded) {
            int rooms = bench.choose(3, ROOMS, ROOMS);
            Trial trial = bench.choose(
                    new Trial(50, 6, 12, 6, 5),
                    new Trial(300, 20 * ROOMS, 60 * ROOMS, 10 * ROOMS, 60),
                    new Trial(2000, 150 * ROOMS, 1500 * ROOMS, 75 * ROOMS, 300));
            bench.measure(name(), "apsis", 250, trial, () -> new Rooms(rooms));
        } else {
            int[] sizes = {10, 100, 250, 1000};
            for (int n : bench.choose(new int[] {10, 50}, sizes, sizes)) {
                Trial trial = bench.choose(
                        new Trial(100, 20, 40, 20, 5),
                        new Trial(500, 150, 600, 30, 30),
                        new Trial(2000, 150, 3000, 50, 60));
                bench.measure(name(), "apsis", n, trial, () -> new WorldCourse(room(n, 1)));
            }
        }
    }

    private static World room(int bodies, long seed) {
        Scene scene = SceneCatalogue.byName(SCENE, bodies).orElseThrow();
        return scene.world(seed);
    }

    private static final class Rooms implements Course {
        private final List<WorldCourse> rooms;
        private int next;

        Rooms(int count) {
            rooms = LongStream.range(0, count)
                    .mapToObj(seed -> new WorldCourse(room(250, seed)))
                    .toList();
        }

        @Override
        public void step() {
            rooms.get(next).step();
            next = (next + 1) % rooms.size();
        }

        @Override
        public void look() {
            rooms.forEach(Course::look);
        }

        @Override
        public List<Finding> findings() {
            return List.of(worst(0), worst(1));
        }

        private Finding worst(int finding) {
            return rooms.stream()
                    .map(room -> room.findings().get(finding))
                    .reduce((a, b) -> a.value() >= b.value() ? a : b)
                    .orElseThrow();
        }
    }
}

package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.Overlaps;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.scenes.Scene;
import io.github.apsis.scenes.SceneBody;
import io.github.apsis.scenes.SceneCatalogue;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;

/** The public room with ten thousand bodies: 9500 that attract by a tree and collide, and 500 ships. */
final class Moonshot implements SpeedScene {
    private static final double SHIPS = 0.05; // of all
    private static final double THETA = 0.5;
    private static final double OTHERS_IN_SCENE = 0.83; // the scene makes a sixth of its bodies ships, too many here

    @Override
    public String name() {
        return "moonshot";
    }

    @Override
    public String description() {
        return "Belt and swarm with gravity by a tree, opening angle 0.5, contacts, and one body in twenty a ship: what fits into"
                + " the 6.67 ms of a tick is the p99. `force-rms`, `force-median`, `force-worst` as above, at the end;"
                + " `overlap`: the deepest at the end, in radii of the smaller.";
    }

    @Override
    public boolean usesThreads() {
        return true;
    }

    @Override
    public void run(Bench bench) {
        for (int n : bench.choose(new int[] {60}, new int[] {1000, 10_000}, new int[] {1000, 10_000, 20_000})) {
            Trial trial = bench.choose(
                    new Trial(50, 10, 20, 10, 5), new Trial(500, 30, 120, 10, 10), new Trial(2000, 150, 1500, 25, 120));
            bench.measure(name(), "apsis", n, trial, () -> new Attracting(world(bench, n)));
        }
    }

    private static World world(Bench bench, int count) {
        int ships = (int) (SHIPS * count);
        Scene scene = SceneCatalogue.byName("belt-and-swarm", (int) (count * (1 - SHIPS) / OTHERS_IN_SCENE))
                .orElseThrow();
        World world = new World(bench.spec(laws(scene.spec(1))));
        List<SceneBody> wanted = new ArrayList<>();
        int others = 0;
        int flying = 0;
        for (SceneBody body : scene.bodies(1)) {
            boolean isShip = body.def().kind() == BodyKind.SHIP;
            if (isShip ? flying < ships : others < count - ships) {
                wanted.add(body);
                flying += isShip ? 1 : 0;
                others += isShip ? 0 : 1;
            }
        }
        wanted.forEach(body -> world.add(body.def()));
        return world;
    }

    private static WorldSpec.Builder laws(WorldSpec scene) {
        Boundary.Walls walls = (Boundary.Walls) scene.boundary();
        return WorldSpec.builder()
                .gravity(scene.gravity())
                .tree(THETA)
                .contacts(scene.restitution().orElseThrow())
                .walls(walls.box(), walls.restitution())
                .seed(scene.seed());
    }

    private static final class Attracting implements Course {
        private final World world;

        Attracting(World world) {
            this.world = world;
        }

        @Override
        public void step() {
            world.step();
        }

        @Override
        public List<Finding> findings() {
            WorldSnapshot now = world.snapshot();
            // The first is the planet, which is fixed; ships have engines.
            IntPredicate isFree = body -> body > 0 && now.kind(body) != BodyKind.SHIP;
            List<Finding> findings = new ArrayList<>(ForceCheck.of(now, world.spec(), isFree));
            double deepest = Overlaps.of(now, world.spec().boundary()).deepest();
            findings.add(new Finding("overlap", deepest));
            return findings;
        }

        @Override
        public void end() {
            world.close();
        }
    }
}

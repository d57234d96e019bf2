package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.speed.SpeedStudy.Length;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.scenes.Scene;
import io.github.apsis.scenes.SceneBody;
import io.github.apsis.scenes.SceneCatalogue;
import java.util.ArrayList;
import java.util.List;

/** The public room with ten thousand bodies: 9500 that attract by a tree and collide, and 500 ships. */
final class Moonshot implements SpeedScene {
    private static final double SHIPS = 0.05; // of all
    private static final double THETA = 0.9; // as loose as a force error of 1e-4 lets it be
    private static final int TEN_MINUTES = 90_000; // steps
    private static final double OTHERS_IN_SCENE = 0.83; // the scene makes a sixth of its bodies ships, too many here

    @Override
    public String name() {
        return "moonshot";
    }

    @Override
    public String description() {
        return "Belt and swarm with gravity by a tree, opening angle 0.9, contacts, and one body in twenty a ship: what fits into"
                + " the 6.67 ms of a tick is the p99. 10 000 bodies on several threads have ten minutes of it. `force-rms`,"
                + " `force-median`, `force-worst` as above, the largest of the looks at the end of each minute; `overlap`:"
                + " the deepest at the end, in radii of the smaller; `p99-first-minute`, `p99-last-minute`, `max`: of a tick"
                + " by the clock, ms; `late`: the share of ticks that took longer than 6.67 ms.";
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
            if (bench.length() == Length.FULL && bench.threads() > 1 && n == 10_000) {
                trial = new Trial(2000, 150, TEN_MINUTES, 25, Integer.MAX_VALUE);
            }
            bench.measure(name(), "apsis", n, trial, () -> new LongCourse(world(bench, n)));
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
}

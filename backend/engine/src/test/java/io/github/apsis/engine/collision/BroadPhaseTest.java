package io.github.apsis.engine.collision;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.math.Rng;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.spatial.Workspace;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BroadPhaseTest {
    private static final double DT = 1.0 / 150;
    private static final int BODIES = 400;
    private static final Aabb WORLD = new Aabb(-500, -500, 500, 500);

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void no_pair_that_meets_in_an_open_world_is_overlooked(long seed) {
        overlooksNothing(seed, null);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6})
    void no_pair_that_meets_in_a_periodic_world_is_overlooked(long seed) {
        overlooksNothing(seed, new Period(WORLD));
    }

    /** Radii from a hundredth to a hundred, speeds from nothing to two worlds in a tick, paths that bend. */
    private static void overlooksNothing(long seed, @Nullable Period period) {
        var rng = new Rng(seed);
        Bodies bodies = bodies(rng, period);
        var paths = new Paths();
        paths.begin(bodies, DT);
        bodies.drift(DT);
        var broadPhase = new BroadPhase(period, Team.ofOne(), new Workspace());
        broadPhase.build(bodies, paths);

        assertThat(found(broadPhase)).as("seed %d", seed).containsAll(meeting(bodies, paths, period));

        for (int bend = 0; bend < 100; bend++) {
            int i = rng.nextInt(BODIES);
            paths.bend(bodies, i, rng.between(0, DT), rng.between(-1000, 1000), rng.between(-1000, 1000));
            broadPhase.update(bodies, paths, i);

            assertThat(found(broadPhase, i))
                    .as("seed %d, body %d", seed, i)
                    .containsAll(meeting(bodies, paths, period, i));
        }
    }

    private static Bodies bodies(Rng rng, @Nullable Period period) {
        var bodies = new Bodies();
        for (int i = 0; i < BODIES; i++) {
            double radius = StrictMath.pow(10, rng.between(-2, 2));
            double speed = StrictMath.pow(10, rng.between(0, i % 20 == 0 ? 5.5 : 4));
            double angle = rng.between(0, 2 * Math.PI);
            double x = rng.between(WORLD.minX(), WORLD.maxX());
            double y = rng.between(WORLD.minY(), WORLD.maxY());
            bodies.add(BodyDef.planet(x, y, 1, radius)
                    .moving(speed * StrictMath.cos(angle), speed * StrictMath.sin(angle)));
            bodies.setAcceleration(i, rng.between(-1e4, 1e4), rng.between(-1e4, 1e4));
        }
        return bodies;
    }

    private static List<String> found(BroadPhase broadPhase) {
        List<String> found = new ArrayList<>();
        int pairs = broadPhase.findPairs();
        for (int k = 0; k < pairs; k++) {
            found.add(broadPhase.first(k) + " " + broadPhase.second(k));
        }
        assertThat(found).doesNotHaveDuplicates();
        return found;
    }

    private static List<Integer> found(BroadPhase broadPhase, int i) {
        List<Integer> found = new ArrayList<>();
        int hits = broadPhase.findNear(i);
        for (int hit = 0; hit < hits; hit++) {
            found.add(broadPhase.near(hit));
        }
        assertThat(found).doesNotHaveDuplicates();
        return found;
    }

    private static List<String> meeting(Bodies bodies, Paths paths, @Nullable Period period) {
        var meeting = new Meeting(paths, period, ContactMode.TICK);
        List<String> pairs = new ArrayList<>();
        for (int i = 0; i < BODIES; i++) {
            for (int j = i + 1; j < BODIES; j++) {
                if (meet(meeting, bodies, i, j)) {
                    pairs.add(i + " " + j);
                }
            }
        }
        assertThat(pairs).isNotEmpty();
        return pairs;
    }

    private static List<Integer> meeting(Bodies bodies, Paths paths, @Nullable Period period, int i) {
        var meeting = new Meeting(paths, period, ContactMode.TICK);
        List<Integer> partners = new ArrayList<>();
        for (int j = 0; j < BODIES; j++) {
            if (j != i && meet(meeting, bodies, Math.min(i, j), Math.max(i, j))) {
                partners.add(j);
            }
        }
        return partners;
    }

    private static boolean meet(Meeting meeting, Bodies bodies, int a, int b) {
        double sumOfRadii = bodies.radius(a) + bodies.radius(b);
        meeting.of(bodies, a, b);
        return !Double.isNaN(meeting.time(bodies, sumOfRadii)) || meeting.lastDistance() < sumOfRadii;
    }
}

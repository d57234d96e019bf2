package io.github.apsis.server.room;

import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.scenes.Measures;
import io.github.apsis.scenes.Palette;
import io.github.apsis.scenes.Palette.Range;
import io.github.apsis.scenes.Scene;
import io.github.apsis.scenes.SceneBody;
import io.github.apsis.scenes.Units;
import java.util.Arrays;
import java.util.List;

/** Walls at ±200, no gravity, and whatever a test puts in. Its planets are so large that one fits. */
class TestScene implements Scene {
    static final ShipLimits LIMITS = new ShipLimits(100, 1000);

    private final List<SceneBody> bodies;

    TestScene(BodyDef... bodies) {
        this.bodies =
                Arrays.stream(bodies).map(body -> new SceneBody(body, null)).toList();
    }

    static BodyDef ship(double x, double y) {
        return BodyDef.ship(x, y, 5, 4, LIMITS);
    }

    @Override
    public String name() {
        return "test";
    }

    @Override
    public String title() {
        return "Test";
    }

    @Override
    public Units units() {
        return new Units("u", "kg", "s");
    }

    @Override
    public Aabb view() {
        return Aabb.centred(200, 200);
    }

    @Override
    public Measures measures() {
        return Measures.ENERGY_AND_MOMENTUM;
    }

    @Override
    public WorldSpec spec(long seed) {
        return laws(WorldSpec.builder().walls(Aabb.centred(200, 200), 1).seed(seed))
                .build();
    }

    WorldSpec.Builder laws(WorldSpec.Builder walls) {
        return walls;
    }

    @Override
    public List<SceneBody> bodies(long seed) {
        return bodies;
    }

    @Override
    public Palette palette() {
        return new Palette(
                Aabb.centred(100, 100), new Range(90, 90), new Range(1, 1), new Range(5, 6), 1, 10, 1, 4, 5, LIMITS);
    }
}

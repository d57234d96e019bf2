package io.github.apsis.scenes;

import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.scenes.Palette.Range;
import java.util.List;

/**
 * Three equal planets that chase each other along one curve, an eight: Chenciner and Montgomery (2000, Annals of
 * Mathematics 152, 881). Stable, so it survives rounding for good; a body dropped beside it may break it.
 *
 * <p>The initial conditions are those that the paper gives (found by C. Simó) for G = m = 1 and a period of 6.32591398. Here a length
 * is 200 times as long and time is the same, so G · m = 200³.
 */
final class FigureEight implements Scene {
    static final double PERIOD = 6.32591398; // s
    private static final double LENGTH = 200; // u
    private static final double MASS = 1000;
    private static final int MOST_BODIES = 100; // as many pairs as an adaptive tick has time for
    private static final double X = 0.97000436;
    private static final double Y = -0.24308753;
    private static final double VX = -0.93240737;
    private static final double VY = -0.86473146;

    @Override
    public String name() {
        return "figure-eight";
    }

    @Override
    public String title() {
        return "Figure eight";
    }

    @Override
    public Units units() {
        return new Units("u", "kg", "s");
    }

    @Override
    public Aabb view() {
        return Aabb.centred(280, 180);
    }

    @Override
    public Measures measures() {
        return Measures.ENERGY_AND_MOMENTUM;
    }

    /** The three never touch; contacts are for what people add. */
    @Override
    public WorldSpec spec(long seed) {
        return WorldSpec.builder()
                .gravity(LENGTH * LENGTH * LENGTH / MASS)
                .contacts(0.8)
                .adaptive(1e-16)
                .maxBodies(MOST_BODIES)
                .seed(seed)
                .build();
    }

    @Override
    public List<SceneBody> bodies(long seed) {
        return List.of(
                planet(X, Y, -VX / 2, -VY / 2), //
                planet(-X, -Y, -VX / 2, -VY / 2),
                planet(0, 0, VX, VY));
    }

    private static SceneBody planet(double x, double y, double vx, double vy) {
        BodyDef atRest = BodyDef.planet(x * LENGTH, y * LENGTH, MASS, 12);
        return SceneBody.plain(atRest.moving(vx * LENGTH, vy * LENGTH));
    }

    @Override
    public Palette palette() {
        return new Palette(
                view(),
                new Range(4, 8),
                new Range(0.2, 1),
                new Range(3, 6),
                0.002,
                120,
                1.5,
                6,
                0.1,
                new ShipLimits(200, 60));
    }
}

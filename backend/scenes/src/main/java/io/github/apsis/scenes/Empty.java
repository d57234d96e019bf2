package io.github.apsis.scenes;

import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.scenes.Palette.Range;
import java.util.List;

/** Nothing yet: gravity, contacts, walls, and room for what people add. */
final class Empty implements Scene {
    private static final Aabb BOX = Aabb.centred(1000, 1000);

    @Override
    public String name() {
        return "empty";
    }

    @Override
    public String title() {
        return "Empty space";
    }

    @Override
    public Units units() {
        return new Units("u", "kg", "s");
    }

    @Override
    public Aabb view() {
        return Aabb.centred(520, 450);
    }

    @Override
    public Measures measures() {
        return Measures.ENERGY_AND_MOMENTUM;
    }

    @Override
    public WorldSpec spec(long seed) {
        return WorldSpec.builder()
                .gravity(16)
                .contacts(0.8)
                .walls(BOX, 0.8)
                .seed(seed)
                .build();
    }

    @Override
    public List<SceneBody> bodies(long seed) {
        return List.of();
    }

    /** Planets of 5000 to 60000: heavy enough to bend every path in sight, slow enough to each other to watch. */
    @Override
    public Palette palette() {
        return new Palette(
                Aabb.centred(500, 430),
                new Range(14, 34),
                new Range(8, 17),
                new Range(3, 14),
                0.3,
                40,
                1.5,
                7,
                12,
                new ShipLimits(120, 2400));
    }
}

package io.github.apsis.benchmarks.discs;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.force.UniformField;
import org.jspecify.annotations.Nullable;

/** A scene in a world of ours. */
final class ApsisDiscs implements DiscEngine {
    private final World world;
    private @Nullable WorldSnapshot state;

    ApsisDiscs(DiscScene scene, ContactMode mode) {
        WorldSpec.Builder spec = WorldSpec.builder().dt(scene.dt());
        if (scene.fieldX() != 0 || scene.fieldY() != 0) {
            spec.law(new UniformField(scene.fieldX(), scene.fieldY()));
        }
        if (!scene.walls().isEmpty()) {
            spec.halfPlanes(scene.walls(), scene.restitution());
        }
        world = new World(mode.on(spec, scene.restitution()).build());
        for (DiscScene.Disc disc : scene.discs()) {
            BodyDef body = BodyDef.planet(disc.x(), disc.y(), disc.mass(), disc.radius());
            world.add(disc.isFixed() ? body.fixed() : body.moving(disc.vx(), disc.vy()));
        }
    }

    @Override
    public void step() {
        world.step();
        state = null;
    }

    /** Read once per tick, and only where somebody looks: a copy of all bodies is no part of a tick. */
    private WorldSnapshot state() {
        WorldSnapshot read = state;
        if (read == null) {
            read = world.snapshot();
            state = read;
        }
        return read;
    }

    @Override
    public double x(int i) {
        return state().x(i);
    }

    @Override
    public double y(int i) {
        return state().y(i);
    }

    @Override
    public double vx(int i) {
        return state().vx(i);
    }

    @Override
    public double vy(int i) {
        return state().vy(i);
    }
}

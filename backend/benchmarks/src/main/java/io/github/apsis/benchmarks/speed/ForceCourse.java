package io.github.apsis.benchmarks.speed;

import io.github.apsis.engine.World;
import java.util.List;

/** A tick too short to move anything: one evaluation of the forces, against the true ones. */
final class ForceCourse implements Course {
    private final World world;

    ForceCourse(World world) {
        this.world = world;
    }

    @Override
    public void step() {
        world.step();
    }

    @Override
    public List<Finding> findings() {
        return ForceCheck.of(world.snapshot(), world.spec(), i -> true);
    }

    @Override
    public void end() {
        world.close();
    }
}

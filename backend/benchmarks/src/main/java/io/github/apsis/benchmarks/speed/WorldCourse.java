package io.github.apsis.benchmarks.speed;

import io.github.apsis.benchmarks.Balance;
import io.github.apsis.engine.World;
import java.util.List;

/** A world of ours: what it conserves, and how deep its bodies are in each other. */
final class WorldCourse implements Course {
    private final World world;
    private final Balance balance;

    WorldCourse(World world) {
        this.world = world;
        this.balance = new Balance(world);
    }

    @Override
    public void step() {
        world.step();
    }

    @Override
    public void look() {
        balance.look();
    }

    @Override
    public List<Finding> findings() {
        return List.of(
                new Finding("energy-drift", balance.worstEnergyDrift()),
                new Finding("overlap", balance.deepestOverlap()));
    }
}

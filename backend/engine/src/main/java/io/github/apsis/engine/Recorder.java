package io.github.apsis.engine;

import java.util.ArrayList;
import java.util.List;

/** Notes what is done to a world from its beginning on: all its commands must go through here. */
public final class Recorder {
    private final World world;
    private final List<Recording.Entry> done = new ArrayList<>();

    /**
     * @throws IllegalArgumentException when the world has begun already
     */
    public Recorder(World world) {
        if (world.tick() != 0 || world.count() != 0) {
            throw new IllegalArgumentException("a recording begins with an empty world at tick 0, this one has "
                    + world.count() + " bodies at tick " + world.tick());
        }
        this.world = world;
    }

    /** {@link World#apply}, noted if it was accepted. */
    public CommandResult apply(Command command) {
        CommandResult result = world.apply(command);
        if (result instanceof CommandResult.Accepted) {
            done.add(new Recording.Entry(world.tick(), command));
        }
        return result;
    }

    /** Everything so far. */
    public Recording recording() {
        return new Recording(done, world.tick());
    }
}

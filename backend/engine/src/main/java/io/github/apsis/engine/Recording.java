package io.github.apsis.engine;

import java.util.List;

/**
 * How a world came to be what it is: the commands that were done to it, each with its tick. Immutable, and plain data: whoever wants to
 * keep a world in mid-run keeps this.
 *
 * <p>With the same spec it {@link #replay replays} to the same bits, on any machine and by any number of threads. That includes what no
 * copy of the bodies has: the impulses that contacts remember, the step that an integrator is in. It takes as long as the world took.
 *
 * @param commands in the order in which they were done, those that were refused left out
 * @param ticks how many the world had when it was recorded
 */
public record Recording(List<Entry> commands, long ticks) {
    /** A command that was done after this tick. */
    public record Entry(long tick, Command command) {}

    public Recording {
        commands = List.copyOf(commands);
        long last = 0;
        for (Entry entry : commands) {
            if (entry.tick() < last || entry.tick() > ticks) {
                throw new IllegalArgumentException("commands must be in order and at ticks 0 to " + ticks + ", was "
                        + entry.tick() + " after " + last);
            }
            last = entry.tick();
        }
    }

    /**
     * A world of these laws that has lived through all this.
     *
     * @throws IllegalArgumentException when a command is refused: the spec is not that of the recording
     */
    public World replay(WorldSpec spec) {
        World world = new World(spec);
        for (Entry entry : commands) {
            stepTo(world, entry.tick());
            if (world.apply(entry.command()) instanceof CommandResult.Rejected rejected) {
                world.close();
                throw new IllegalArgumentException("not a recording of such a world: at tick " + entry.tick() + " "
                        + entry.command() + " is refused, " + rejected.reason());
            }
        }
        stepTo(world, ticks);
        return world;
    }

    private static void stepTo(World world, long tick) {
        while (world.tick() < tick) {
            world.step();
        }
    }
}

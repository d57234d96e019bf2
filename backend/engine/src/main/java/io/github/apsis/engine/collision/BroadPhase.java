package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.spatial.CircleGrid;
import io.github.apsis.engine.spatial.Workspace;
import org.jspecify.annotations.Nullable;

/**
 * Finds the bodies whose paths through the tick come near a body's own: a grid of the circles around the whole paths of moving
 * bodies, so that nothing fast is overlooked.
 *
 * <p>Made anew every tick. Circles with room for three ticks, and their pairs kept as long as nobody leaves his (Verlet 1967, Phys.
 * Rev. 159, 98), give the same bits and gain nothing in a gas of 1000: the grids take 12 µs a tick and not 20, but bounces look
 * around farther and more pairs are looked at in vain, so a tick takes 41 µs and not 40; room for more ticks is a loss.
 */
final class BroadPhase {
    /** Two circles that only graze may do so by rounding. */
    private static final double GRAZING = 1 + 1e-9;

    private final CircleGrid grid;

    private double mostAcceleration;

    BroadPhase(@Nullable Period period, Team team, Workspace workspace) {
        grid = new CircleGrid(period, team, workspace);
    }

    /** Sorts the paths of all bodies. */
    void build(Bodies bodies, Paths paths) {
        grid.begin(bodies.count());
        paths.enclose(bodies, grid.centresX(), grid.centresY(), grid.radii());
        widen(grid.radii(), bodies.count());
        grid.takeAll();
        mostAcceleration = bodies.mostAcceleration();
        grid.build();
    }

    private static void widen(double[] radii, int count) {
        for (int i = 0; i < count; i++) {
            radii[i] *= GRAZING;
        }
    }

    /** No body that was sorted is accelerated more. */
    double mostAcceleration() {
        return mostAcceleration;
    }

    /** Finds all pairs whose paths may touch, each once: {@link #first} and {@link #second} give them, and how many is returned. */
    int findPairs() {
        return grid.findPairs();
    }

    int first(int pair) {
        return grid.first(pair);
    }

    int second(int pair) {
        return grid.second(pair);
    }

    /** The path of a body has been bent. */
    void update(Bodies bodies, Paths paths, int i) {
        grid.move(i, x(bodies, paths, i), y(bodies, paths, i), reach(bodies, paths, i));
    }

    private static double acceleration(Bodies bodies, int i) {
        return Math.abs(Paths.accelerationX(bodies, i)) + Math.abs(Paths.accelerationY(bodies, i));
    }

    private static double x(Bodies bodies, Paths paths, int i) {
        return paths.startX(i) + 0.5 * (bodies.x(i) - paths.startX(i));
    }

    private static double y(Bodies bodies, Paths paths, int i) {
        return paths.startY(i) + 0.5 * (bodies.y(i) - paths.startY(i));
    }

    private static double reach(Bodies bodies, Paths paths, int i) {
        double wx = bodies.x(i) - paths.startX(i);
        double wy = bodies.y(i) - paths.startY(i);
        double room = paths.room(paths.dt() - paths.startTime(i));
        return GRAZING * (bodies.radius(i) + 0.5 * Math.sqrt(wx * wx + wy * wy) + acceleration(bodies, i) * room);
    }

    /**
     * Finds the bodies, in a fixed order, whose paths may touch that of body {@code i} since it was last bent; itself is among
     * them. In a periodic world also across the seam.
     *
     * @return how many; {@link #near} gives them until the next call
     */
    int findNear(int i) {
        return grid.query(i);
    }

    int near(int hit) {
        return grid.found(hit);
    }
}

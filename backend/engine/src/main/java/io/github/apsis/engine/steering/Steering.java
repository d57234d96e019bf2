package io.github.apsis.engine.steering;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.parallel.Work;
import io.github.apsis.engine.spatial.Workspace;
import java.util.function.Supplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/**
 * Decides one thrust per ship and tick, held through the tick.
 *
 * <p>A ship prefers a velocity, by {@link Seek} while it has a target and by {@link Wander} otherwise; the {@link Planner}
 * makes a course of it that keeps clear of others, and the {@link Helm} a thrust. A target replaces wandering, never avoidance.
 *
 * <p>All ships read what was true at the start and write their own columns alone: neither their order nor the number of
 * threads can change a bit. What a ship remembers is in {@link Bodies}; from one tick to the next nothing is kept here.
 */
public final class Steering {
    /** Ships from which on a team is asked: they take 0.2 ms, half of which is more than it takes to wake. */
    private static final int MANY = 192;

    private static final int PER_PIECE = 32;

    private final Neighbours neighbours;
    private final Courses courses = new Courses();
    private final Team alone = Team.ofOne();
    private final Team team;
    private final Supplier<Helm> newHelm;
    private Helm[] helms = new Helm[0]; // one for each of the team, once there are ships
    private final boolean looksAround;
    private final Work piece = this::steerPiece;

    private Bodies bodies = new Bodies(); // of the present decision, as all below
    private int[] ships = new int[0];
    private long tick;
    private double dt;

    /**
     * Steering whose wanderers go where chance leads them.
     *
     * @param gravity G of the world, length³ / (mass · time²); 0 without attraction
     * @param seed of the wanderers
     * @param walls around the ships
     * @param period of a world that repeats itself
     * @param team that shares the ships where there are many
     * @param workspace whose columns {@link #decide} uses
     */
    public Steering(
            SteeringSpec spec,
            double gravity,
            long seed,
            @Nullable Aabb walls,
            @Nullable Period period,
            Team team,
            Workspace workspace) {
        this(spec, gravity, new Wander(seed, walls), walls, period, team, workspace);
    }

    /**
     * Steering whose ships without a target go where somebody else wants them to.
     *
     * @param wander is asked by all of the team at once
     */
    public Steering(
            SteeringSpec spec,
            double gravity,
            Preference wander,
            @Nullable Aabb walls,
            @Nullable Period period,
            Team team,
            Workspace workspace) {
        this.team = team;
        looksAround = spec.avoidance() == SteeringSpec.Avoidance.PLANNED;
        neighbours = new Neighbours(team, workspace);
        newHelm = () -> new Helm(spec, neighbours, courses, gravity, wander, walls, period);
    }

    /** Sets the thrust of every ship; accelerations must belong to the present positions. */
    public void decide(Bodies of, long atTick, double timeStep) {
        bodies = of;
        ships = of.ships();
        tick = atTick;
        dt = timeStep;
        if (ships.length == 0) {
            return;
        }
        if (helms.length == 0) {
            helms = Stream.generate(newHelm).limit(team.size()).toArray(Helm[]::new);
        }
        if (looksAround && isAnyDue()) {
            neighbours.sort(bodies, reach());
            courses.copy(bodies);
        }
        (ships.length < MANY ? alone : team).share(piece, (ships.length + PER_PIECE - 1) / PER_PIECE);
    }

    /** Between two thoughts nobody asks who is near. */
    private boolean isAnyDue() {
        for (int i : ships) {
            if (!bodies.isFixed(i) && Planner.isDue(bodies, i, tick, dt)) {
                return true;
            }
        }
        return false;
    }

    private double reach() {
        double reach = 0;
        for (int i : ships) {
            reach = Math.max(reach, Planner.range(bodies, i) + bodies.radius(i));
        }
        return reach;
    }

    private void steerPiece(int number, int member) {
        int end = Math.min(ships.length, (number + 1) * PER_PIECE);
        for (int k = number * PER_PIECE; k < end; k++) {
            if (!bodies.isFixed(ships[k])) {
                helms[member].steer(bodies, ships[k], tick, dt);
            }
        }
    }
}

package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.spatial.Workspace;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * The contacts of a tick, with each other and with walls: first the bounces, each at its true time, then what lies at rest.
 *
 * <p>Works on the paths that an integrator has drawn: {@link #begin} before it moves the bodies, {@link #resolve} after,
 * {@link #settle} when it has finished.
 */
public final class ContactSolver {
    /** Bodies that are held off into others push those on: so far a push is followed in one tick, */
    private static final int MOST_HOLDS = 4;

    /** and so far where it drives them deep into each other, as heavy ones do to light ones. */
    private static final int MOST_HOLDS_OF_PRESSED = 16;

    /** After so many ticks in which heaps were left alone nobody keeps the memory for solving them: a second. */
    private static final int LONG = 150;

    private final Paths paths = new Paths();
    private final Touching touching = new Touching();
    private final Impacts impacts;
    private final Supplier<RestingContacts> restingContacts;
    private @Nullable RestingContacts resting; // once there are any
    private final @Nullable WallStop stop;
    private final HeldBodies held = new HeldBodies();
    private final LyingHeaps lying = new LyingHeaps(paths, touching);
    private final Standstill standstill;
    private boolean heldOnce; // and not again, in this tick

    /**
     * @param restitution between bodies; empty when they do not collide with each other
     * @param boundary whose walls, if it has any, are hit as well
     * @param team that looks for who may meet
     * @param workspace whose columns {@link #resolve} and {@link #settle} use
     */
    public ContactSolver(
            OptionalDouble restitution, Boundary boundary, ContactMode mode, Team team, Workspace workspace) {
        var walls = WallSet.of(boundary);
        double wallRestitution = Boundary.wallRestitution(boundary);
        var period = boundary instanceof Boundary.Periodic p ? new Period(p.box()) : null;
        var broadPhase = restitution.isPresent() ? new BroadPhase(period, team, workspace) : null;
        var approach = new Approach(paths, new ContactGeometry(walls, period), touching, mode);
        impacts = new Impacts(
                restitution.orElse(0),
                wallRestitution,
                broadPhase,
                walls,
                period,
                paths,
                approach,
                touching,
                lying,
                mode,
                workspace);
        restingContacts = () -> new RestingContacts(paths, touching, approach, walls, period);
        standstill = new Standstill(paths, touching, held, lying, workspace);
        stop = walls == null ? null : new WallStop(walls);
    }

    /** Tells a listener of every bounce from now on. */
    public void onBounce(ContactListener listener) {
        impacts.onBounce(listener);
    }

    /** Remembers where the paths of a tick begin, which is at this time since the world began. */
    public void begin(Bodies bodies, double time, double dt) {
        paths.begin(bodies, dt);
        impacts.begin(time);
    }

    /** Bends the paths at every contact. */
    public void resolve(Bodies bodies) {
        impacts.resolve(bodies);
        boolean anyHeld = touching.size() > 0;
        if (anyHeld) {
            hold(bodies);
        }
        if (lying.areLeftAlone()) {
            lying.hold(bodies);
        }
        if (stop != null && anyHeld) {
            stop.stop(bodies, paths.dt());
        } else if (stop != null) {
            stop.stopBent(bodies, paths);
        }
    }

    /** A heap is solved alike however long it has lain, and a large one that has lain for long takes no memory for it. */
    private void forgetHeaps() {
        if (touching.size() >= ImpulseSolver.MANY) {
            return; // another heap is being solved
        }
        if (lying.ticks() == 1) {
            resting().forgetHeap();
        } else if (lying.ticks() == LONG && lying.contacts() >= ImpulseSolver.MANY) {
            resting = null;
            touching.shrink();
        }
    }

    private RestingContacts resting() {
        if (resting == null) {
            resting = restingContacts.get();
        }
        return resting;
    }

    private void hold(Bodies bodies) {
        held.note(bodies, touching);
        int before = touching.size();
        resting().hold(bodies, paths.dt());
        heldOnce = true;
        for (int time = 1; time < mostHolds() && impacts.findIntruders(bodies, held); time++) {
            heldOnce = false;
            held.note(bodies, touching);
            resting().holdAgain(bodies, paths.dt(), before);
            before = touching.size();
        }
        resting().part(bodies, paths.dt());
    }

    private int mostHolds() {
        return resting().isPressed() ? MOST_HOLDS_OF_PRESSED : MOST_HOLDS;
    }

    /** Leaves no pair at rest closing, when positions and velocities belong to the same time. */
    public void settle(Bodies bodies) {
        if (lying.areLeftAlone()) {
            lying.settle(bodies);
            forgetHeaps();
        }
        if (touching.size() > 0) {
            resting().settle(bodies);
            double creep = resting().creep();
            if (creep > 0) {
                standstill.stop(bodies, creep, heldOnce);
            }
        }
    }
}

package io.github.apsis.engine;

import io.github.apsis.engine.CommandResult.Accepted;
import io.github.apsis.engine.CommandResult.Reason;
import io.github.apsis.engine.CommandResult.Rejected;
import io.github.apsis.engine.WorldSpec.GravityMethod;
import io.github.apsis.engine.WorldSpec.Integration;
import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.Ledger;
import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.engine.collision.ContactListener;
import io.github.apsis.engine.collision.ContactMode;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.diagnostics.ForceError;
import io.github.apsis.engine.diagnostics.Resolution;
import io.github.apsis.engine.force.AdaptiveGravity;
import io.github.apsis.engine.force.DirectGravity;
import io.github.apsis.engine.force.ForceLaw;
import io.github.apsis.engine.force.Forces;
import io.github.apsis.engine.force.GravitySolver;
import io.github.apsis.engine.force.GravitySolver.Method;
import io.github.apsis.engine.force.NearestImageGravity;
import io.github.apsis.engine.force.TreeGravity;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.integration.AdaptiveTaylor;
import io.github.apsis.engine.integration.Integrator;
import io.github.apsis.engine.integration.Pefrl;
import io.github.apsis.engine.integration.SemiImplicitEuler;
import io.github.apsis.engine.integration.Symplectic8;
import io.github.apsis.engine.integration.TaylorStep;
import io.github.apsis.engine.integration.VelocityVerlet;
import io.github.apsis.engine.integration.Yoshida4;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.spatial.Workspace;
import io.github.apsis.engine.steering.Steering;
import io.github.apsis.engine.stepping.EventStepper;
import io.github.apsis.engine.stepping.Stepper;
import io.github.apsis.engine.stepping.TickStepper;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * One simulation: bodies under the laws of a {@link WorldSpec}, advanced tick by tick.
 *
 * <p>A world is changed by {@link #apply} and {@link #step} alone, from one thread at a time; what it hands out is a copy.
 * The same spec and the same commands at the same ticks give the same bits, on every machine and by any number of threads.
 */
public final class World implements AutoCloseable {
    private final WorldSpec spec;
    private final Bodies bodies = new Bodies();
    private final Team team;
    private final @Nullable ForceLaw gravity;
    private final Forces forces;
    private final Steering steering;
    private final Stepper stepper;
    private final Departures departures = new Departures();
    private final @Nullable Wrecks wrecks; // null where ships go on
    private long tick;
    private boolean numbersKnown; // of all bodies since the last tick: only what is added may be beyond them

    public World(WorldSpec spec) {
        this.spec = spec;
        team = new Team(spec.threads());
        var workspace = new Workspace(); // decisions, gravity and contacts follow each other
        gravity = gravityOf(spec, team, workspace);
        forces = new Forces(lawsOf(gravity, spec));
        steering = steeringOf(spec, team, workspace);
        stepper = stepperOf(spec, forces, team, workspace);
        wrecks = spec.shipsAreMortal() ? new Wrecks(bodies) : null;
        if (wrecks != null) {
            stepper.onBounce(wrecks);
        }
    }

    /**
     * Advances by one tick: ships decide, bodies move, contacts bend their paths, the edge of the world has its say. What is
     * too far or too fast for numbers then leaves the world, and so do mortal ships that ran into something: {@link #departures}. A
     * tick of no length changes no body.
     *
     * @throws IllegalStateException when a body is nowhere (NaN); the world must not be used any more
     */
    public void step() {
        departures.beginTick();
        if (spec.dt() > 0) {
            if (!numbersKnown && stepper.needsNumbers() && !bodies.areWithinNumbers()) {
                letGo(); // powers of such a speed are beyond a series, and no wall holds it
            }
            adaptGravity();
            decide();
            stepper.step(bodies, time());
        }
        tick++;
        if (wrecks != null) {
            wrecks.clear(tick, departures);
        }
        if (!bodies.areWithinNumbers()) {
            requireNumbers();
            letGo();
        }
        numbersKnown = true;
    }

    /**
     * Ends the threads of a world that shares its ticks among several; one of a single thread need not be closed. The world
     * can still be used, by the caller's thread alone and with the same bits.
     */
    @Override
    public void close() {
        team.close();
    }

    /** Tells a listener of every bounce from now on; there is one listener, the last. */
    public void onBounce(ContactListener listener) {
        if (wrecks != null) {
            wrecks.tell(listener);
        } else {
            stepper.onBounce(listener);
        }
    }

    private void decide() {
        if (bodies.ships().length > 0) {
            forces.ensureCurrent(bodies);
            steering.decide(bodies, tick, spec.dt());
        }
    }

    private void adaptGravity() {
        if (gravity instanceof AdaptiveGravity adaptive && adaptive.adapt(bodies)) {
            bodies.outdateAccelerations();
        }
    }

    /** Does one command now, between two ticks, or says why it cannot be done. */
    public CommandResult apply(Command command) {
        if (command instanceof Command.AddBody add) {
            return add(add);
        }
        if (command instanceof Command.RemoveBody remove) {
            return remove(remove);
        }
        if (command instanceof Command.SeekTarget seek) {
            return seek(seek);
        }
        return wander((Command.Wander) command);
    }

    /**
     * Adds a body, for callers who know that it can be done.
     *
     * @throws IllegalArgumentException when it cannot
     */
    public BodyId add(BodyDef body) {
        CommandResult result = apply(new Command.AddBody(body));
        if (result instanceof Accepted accepted) {
            return accepted.body();
        }
        throw new IllegalArgumentException("cannot add " + body + ": " + ((Rejected) result).reason());
    }

    private CommandResult add(Command.AddBody command) {
        if (bodies.count() >= spec.maxBodies()) {
            return new Rejected(Reason.WORLD_FULL);
        }
        BodyDef body = command.body();
        numbersKnown = false;
        if (!spec.boundary().takes(body.x(), body.y(), body.radius())) {
            return new Rejected(Reason.OUTSIDE_WORLD);
        }
        return new Accepted(bodies.id(bodies.add(body)));
    }

    private CommandResult remove(Command.RemoveBody command) {
        int slot = bodies.slotOf(command.body());
        if (slot < 0) {
            return new Rejected(Reason.NO_SUCH_BODY);
        }
        bodies.remove(slot);
        return new Accepted(command.body());
    }

    private CommandResult seek(Command.SeekTarget command) {
        int slot = bodies.slotOf(command.ship());
        if (slot < 0) {
            return new Rejected(Reason.NO_SUCH_BODY);
        }
        if (!bodies.isShip(slot)) {
            return new Rejected(Reason.NOT_A_SHIP);
        }
        if (!spec.boundary().holds(command.x(), command.y(), 0)) {
            return new Rejected(Reason.OUTSIDE_WORLD);
        }
        bodies.setTarget(slot, command.x(), command.y());
        return new Accepted(command.ship());
    }

    private CommandResult wander(Command.Wander command) {
        int slot = bodies.slotOf(command.ship());
        if (slot < 0) {
            return new Rejected(Reason.NO_SUCH_BODY);
        }
        if (!bodies.isShip(slot)) {
            return new Rejected(Reason.NOT_A_SHIP);
        }
        bodies.clearTarget(slot);
        return new Accepted(command.ship());
    }

    /** An immutable copy of all bodies. */
    public WorldSnapshot snapshot() {
        forces.ensureCurrent(bodies);
        return new WorldSnapshot(tick, time(), bodies);
    }

    /**
     * The conserved quantities, measured now; costs about as much as the forces of one tick. {@code Drift.between} two of them
     * tells what the numerics did meanwhile.
     */
    public Conserved conserved() {
        return Conserved.of(bodies, forces, periodOf(spec));
    }

    /** The spacing of doubles as a share of what a body moves in a tick, the worst of all: see {@link Resolution}. */
    public double resolution() {
        return Resolution.of(bodies, spec.dt());
    }

    /** How gravity is summed at present. */
    public GravitySolver gravitySolver() {
        if (gravity instanceof AdaptiveGravity adaptive) {
            return adaptive.solver(bodies.count());
        }
        if (gravity instanceof TreeGravity tree) {
            return GravitySolver.of(Method.TREE, tree.theta());
        }
        if (gravity == null) {
            return GravitySolver.of(Method.NONE, 0);
        }
        return GravitySolver.of(gravity instanceof DirectGravity ? Method.DIRECT : Method.NEAREST_IMAGE, 0);
    }

    /**
     * How far gravity, as it is summed at present, is from the exact sum; measured now on 64 bodies, without effect on the
     * world. Empty without gravity and in a periodic world, whose nearest images are another law.
     */
    public Optional<ForceError> forceError() {
        return gravity == null || gravity instanceof NearestImageGravity
                ? Optional.empty()
                : Optional.of(ForceError.of(bodies, gravity, spec.gravity(), spec.softening()));
    }

    /** The work and the impulses of engines, contacts and walls since the world began. */
    public Ledger ledger() {
        return bodies.ledger();
    }

    /**
     * The bodies that have left of themselves, in that order: all of the last tick, and of those before no more than the last
     * thousand. A view, which the next tick changes; {@link #departed} counts all.
     */
    public List<Departure> departures() {
        return departures.last();
    }

    /** How many bodies have left of themselves since the world began. */
    public long departed() {
        return departures.count();
    }

    /**
     * The {@link #departures} after the first so many: who asks after every tick with what {@link #departed} was the last time
     * misses none.
     */
    public List<Departure> departuresSince(long departed) {
        return departures.since(departed);
    }

    /** What a ship is doing; empty when there is no such ship. */
    public Optional<ShipReading> ship(BodyId ship) {
        int slot = bodies.slotOf(ship);
        return slot >= 0 && bodies.isShip(slot)
                ? Optional.of(ShipReading.of(bodies, slot, periodOf(spec)))
                : Optional.empty();
    }

    /** A hash of the whole state, tick included: equal histories have equal hashes. */
    public long stateHash() {
        return bodies.hash() * 31 + tick;
    }

    /** How often two points have fallen into each other and were turned round, by the adaptive method. */
    public long pointBounces() {
        return stepper.pointBounces();
    }

    /** The time that the bodies are behind the clock, since some ticks needed more steps than the adaptive method takes. */
    public double lostTime() {
        return stepper.lostTime();
    }

    /** Ticks since the world began. */
    public long tick() {
        return tick;
    }

    /** tick · dt: never a sum of steps, so it does not drift. See {@link WorldSpec#timeAt}. */
    public double time() {
        return spec.timeAt(tick);
    }

    /** How many bodies there are. */
    public int count() {
        return bodies.count();
    }

    public WorldSpec spec() {
        return spec;
    }

    private void requireNumbers() {
        for (int i = 0; i < bodies.count(); i++) {
            if (Double.isNaN(bodies.x(i))
                    || Double.isNaN(bodies.y(i))
                    || Double.isNaN(bodies.vx(i))
                    || Double.isNaN(bodies.vy(i))) {
                throw new IllegalStateException(
                        "body " + bodies.idValue(i) + " left the numbers at tick " + tick + ": (" + bodies.x(i) + ", "
                                + bodies.y(i) + ") at (" + bodies.vx(i) + ", " + bodies.vy(i) + ")");
            }
        }
    }

    private void letGo() {
        int i = 0;
        while (i < bodies.count()) {
            if (bodies.isTooFar(i) || bodies.isTooFast(i)) {
                var reason = bodies.isTooFar(i) ? Departure.Reason.TOO_FAR : Departure.Reason.TOO_FAST;
                departures.add(new Departure(bodies.id(i), tick, reason));
                bodies.remove(i);
            } else {
                i++;
            }
        }
    }

    private static @Nullable ForceLaw gravityOf(WorldSpec spec, Team team, Workspace workspace) {
        if (spec.gravity() == 0) {
            return null;
        }
        if (spec.boundary() instanceof Boundary.Periodic p) {
            return new NearestImageGravity(spec.gravity(), spec.softening(), p.box());
        }
        if (spec.gravityMethod() instanceof GravityMethod.Tree tree) {
            return new TreeGravity(spec.gravity(), spec.softening(), tree.theta(), team, workspace);
        }
        if (spec.gravityMethod() instanceof GravityMethod.Adaptive adaptive) {
            return new AdaptiveGravity(spec.gravity(), spec.softening(), adaptive.forceError(), team, workspace);
        }
        return new DirectGravity(spec.gravity(), spec.softening(), team, workspace);
    }

    private static List<ForceLaw> lawsOf(@Nullable ForceLaw gravity, WorldSpec spec) {
        List<ForceLaw> laws = new ArrayList<>();
        if (gravity != null) {
            laws.add(gravity);
        }
        laws.addAll(spec.laws());
        return laws;
    }

    private static Steering steeringOf(WorldSpec spec, Team team, Workspace workspace) {
        var walls = spec.boundary() instanceof Boundary.Walls w ? w.box() : null;
        return new Steering(spec.steering(), spec.gravity(), spec.seed(), walls, periodOf(spec), team, workspace);
    }

    private static @Nullable Period periodOf(WorldSpec spec) {
        return spec.boundary() instanceof Boundary.Periodic p ? new Period(p.box()) : null;
    }

    /** Exact contacts of the adaptive method are found on its series, all others on the parabola of a tick. */
    private static Stepper stepperOf(WorldSpec spec, Forces forces, Team team, Workspace workspace) {
        if (spec.contactMode() == ContactMode.EXACT && spec.integration() == Integration.ADAPTIVE) {
            double restitution = spec.restitution().orElseThrow();
            return new EventStepper(seriesOf(spec), restitution, spec.boundary(), spec.dt());
        }
        return new TickStepper(
                integratorOf(spec),
                forces,
                spec.restitution(),
                spec.contactMode(),
                spec.boundary(),
                spec.dt(),
                team,
                workspace);
    }

    private static Integrator integratorOf(WorldSpec spec) {
        return switch (spec.integration()) {
            case SEMI_IMPLICIT_EULER -> new SemiImplicitEuler();
            case VELOCITY_VERLET -> new VelocityVerlet();
            case YOSHIDA4 -> new Yoshida4();
            case PEFRL -> new Pefrl();
            case SYMPLECTIC8 -> new Symplectic8();
            case ADAPTIVE -> new AdaptiveTaylor(seriesOf(spec));
        };
    }

    private static TaylorStep seriesOf(WorldSpec spec) {
        double fieldX = 0;
        double fieldY = 0;
        for (ForceLaw law : spec.laws()) { // WorldSpec lets nothing else through
            fieldX += ((UniformField) law).gx();
            fieldY += ((UniformField) law).gy();
        }
        return new TaylorStep(spec.gravity(), spec.softening(), fieldX, fieldY, spec.tolerance());
    }
}

package io.github.apsis.engine.collision;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.math.Period;
import org.jspecify.annotations.Nullable;

/**
 * Contacts at rest: bodies that lie on each other neither sink nor tremble, and a body that slides over another keeps its
 * energy.
 *
 * <p>The method is RATTLE (Andersen 1983, J. Comput. Phys. 52, 24) with contacts that push and never pull. {@link #hold}
 * changes velocities in the middle of the tick, along the normal of its start, so that no pair ends it deeper in each other
 * than it began; {@link #settle} takes off what still closes at its end. Both find all impulses at once, from those of the
 * last tick.
 */
final class RestingContacts {
    /** Normals turn and gaps bend as bodies move: impulses found at the first look are corrected at a second, seldom a third. */
    private static final int LOOKS = 3;

    /** What an impulse may miss in one tick, as a share of what it takes off, times the contacts; the next tick goes on from there. */
    private static final double TOLERANCE = 1e-13;

    /** What they do not find, the next tick does, which goes on from there: so a large heap is solved over several ticks. */
    private static final int MOST_ROUNDS = 200;

    /**
     * A large heap that moves asks for other impulses in every tick. After so many rounds a contact misses a fifth of the most that
     * one lacks, and twice as many or a second look leave it hardly less deep: so many,
     */
    private static final int FEWEST_ROUNDS = 50;

    /** or one for so many contacts, since a push goes through a deep heap contact by contact. */
    private static final int CONTACTS_PER_ROUND = 100;

    /**
     * A heap in which somebody is deeper in another than this share of the smaller radius gets all looks and rounds: light bodies between
     * heavy ones need them.
     */
    private static final double DEEP = 0.1;

    /** Fewer contacts are no heap: where they flew radii in a tick it is chance how deep they end, by any of these rules. */
    static final int CROWD = 32;

    /** Circles that do not overlap touch in a planar graph, which has no more than three edges for each node (Euler). */
    private static final int CONTACTS_PER_BODY = 3;

    /** Without rounding conjugate gradients would need one round for each contact that pushes, and as many for each that changes. */
    private static final int ROUNDS_PER_CONTACT = 20;

    /** The cosine of the angle by which a normal may be turned. */
    private static final double NEARLY = 0.9;

    /** Positive work below this share is rounding. */
    private static final double NO_WORK = 1e-13;

    /** Of the speed with which contacts move past each other: while a heap moves, the next tick asks for other impulses anyway. */
    private static final double MOVING = 1e-6;

    /** Of the speed of a heap as a whole: rocks that go round a sun together need not be held better. */
    private static final double FLYING = 1e-9;

    /** A heap is quiet when its bodies move past each other no faster than this share of what forces give them in a tick. */
    private static final double QUIET = 0.2;

    /** Of the speed with which two close at the end of a tick: an impulse that gave them less did not hold them. */
    private static final double ARRIVING = 1e-6;

    /** Impulses that are found to twelve digits and more let a heap creep by 1e-10 of what forces give in a tick, or less. */
    private static final double CREEP = 1e-9;

    /** Those that are found to nine digits let it creep by 1e-6, and gaps that open and close by that by more. */
    private static final double CREEP_OF_MANY = 1e-4;

    /** What holds a heap is much larger than what its contacts miss in a tick; what settles it is not. */
    private static final double STIFFNESS_OF_HOLDING = 1e5;

    private static final double STIFFNESS_OF_SETTLING = 1e3;

    /** Eight units in the last place of a number. */
    private static final double ROUNDING = 0x1p-49;

    private final Paths paths;
    private final Touching touching;
    private final ContactGeometry contact;
    private final Approach approach;
    private final Parting parting;
    private final FirstGuess guess;
    private final HeapSpins spins;
    private final ImpulseSolver solver = new ImpulseSolver();
    private final HeapSolver holding = new HeapSolver(STIFFNESS_OF_HOLDING);
    private final HeapSolver settling = new HeapSolver(STIFFNESS_OF_SETTLING);
    private final ContactPushes pushes = new ContactPushes(solver);
    private boolean isQuiet; // in this tick
    private boolean isPressed; // somebody is deep in another

    // The contacts that are closed at the end of the tick.
    private int[] settled = new int[16];
    private double[] settledX = new double[16]; // their unit normals
    private double[] settledY = new double[16];

    RestingContacts(
            Paths paths, Touching touching, Approach approach, @Nullable WallSet walls, @Nullable Period period) {
        this.paths = paths;
        this.touching = touching;
        this.approach = approach;
        this.contact = new ContactGeometry(walls, period);
        this.parting = new Parting(touching, contact);
        this.guess = new FirstGuess(touching);
        this.spins = new HeapSpins(touching, paths);
    }

    /** Keeps every pair from ending the tick deeper in each other. */
    void hold(Bodies bodies, double dt) {
        if (touching.size() == 0) {
            return;
        }
        isQuiet = isQuiet(bodies, dt);
        isPressed = false;
        for (int k = 0; k < touching.size(); k++) {
            isPressed |= isDeep(bodies, touching.first(k), touching.second(k), touching.firstGap(k));
        }
        solver.begin(touching.size(), bodies);
        for (int k = 0; k < touching.size(); k++) {
            straighten(bodies, k, dt);
        }
        guess.fill(bodies, dt);
        for (int k = 0; k < touching.size(); k++) {
            add(k, guess.impulse(k));
        }
        giveUpCrushed();
        holdAll(bodies, dt);
        for (int k = 0; k < touching.size(); k++) {
            touching.setHolding(k, solver.impulse(k));
        }
    }

    /** Holds once more, when bodies were held off into others that were not in their way: those contacts come after the first. */
    void holdAgain(Bodies bodies, double dt, int before) {
        solver.begin(touching.size(), bodies);
        for (int k = 0; k < touching.size(); k++) {
            if (k >= before) {
                int a = touching.first(k);
                int b = touching.second(k);
                isPressed |= isDeep(bodies, a, b, contact.gapNow(bodies, a, b));
                straighten(bodies, k, dt);
            }
            add(k, k >= before && touching.isRecalled(k) ? touching.holding(k) : 0);
        }
        giveUpCrushed();
        holdAll(bodies, dt);
        for (int k = 0; k < touching.size(); k++) {
            touching.setHolding(k, (k < before ? touching.holding(k) : 0) + solver.impulse(k));
        }
    }

    /** Hundreds that are crushed into each other would make a dense factor, a thousand times as dear, and no tick affords their impulses. */
    private void giveUpCrushed() {
        boolean crushed = solver.size() >= ImpulseSolver.MANY && solver.size() > CONTACTS_PER_BODY * solver.numbers();
        isQuiet &= !crushed;
        isPressed &= solver.size() >= CROWD && !crushed;
    }

    /** Whether a gap is an overlap that should not be: of more than a tenth of the smaller radius. */
    static boolean isDeep(Bodies bodies, int a, int b, double gap) {
        double radius = bodies.radius(a);
        return -gap > DEEP * (b < 0 ? radius : Math.min(radius, bodies.radius(b)));
    }

    /** Whether somebody has been found deep in another in this tick. */
    boolean isPressed() {
        return isPressed;
    }

    /** Parts old overlaps. */
    void part(Bodies bodies, double dt) {
        if (touching.size() > 0) {
            parting.part(bodies, dt, mostRounds(touching.size()), isQuiet);
        }
    }

    /** Solves the next heap as if it were the first. */
    void forgetHeap() {
        holding.forget();
        settling.forget();
        parting.forgetHeap();
    }

    private void add(int k, double guess) {
        solver.add(touching.first(k), touching.second(k), touching.normalX(k), touching.normalY(k), guess);
    }

    private void holdAll(Bodies bodies, double dt) {
        pushes.begin();
        pushes.pushHolding(bodies, dt);
        int looks = isSolvedInPart(touching.size()) ? 1 : LOOKS;
        boolean changed = true;
        for (int look = 0; look < looks && changed; look++) {
            double rounding = measureGaps(bodies, dt);
            int rounds = solve(holding, bodies, rounding);
            changed = rounds > 0;
            if (changed) {
                pushes.pushHolding(bodies, dt);
            }
        }
        if (pushes.didWork(NO_WORK)) {
            holdFlat(bodies, dt);
        }
    }

    /**
     * Turns a normal to where the two impulses have no moment: they act on the whole tick, so that is along the line of the
     * points from which the bodies would have come straight. Unless one has bounced on the way, it had its beginning there.
     */
    private void straighten(Bodies bodies, int k, double dt) {
        int a = touching.first(k);
        int b = touching.second(k);
        if (b >= 0) {
            contact.turn(
                    bodies.x(b) - bodies.vx(b) * dt - (bodies.x(a) - bodies.vx(a) * dt),
                    bodies.y(b) - bodies.vy(b) * dt - (bodies.y(a) - bodies.vy(a) * dt));
            if (contact.nx * touching.normalX(k) + contact.ny * touching.normalY(k) > NEARLY) {
                touching.turn(k, contact.nx, contact.ny);
            }
        }
    }

    /**
     * Asks for no more than that no pair closes along its first normal. That takes energy, or none: it is a projection of the
     * velocities. A light body in a wedge of heavy ones, asked for gaps that bend, would be shot out of it.
     */
    private void holdFlat(Bodies bodies, double dt) {
        double fastest = 0;
        for (int k = 0; k < touching.size(); k++) {
            int a = touching.first(k);
            int b = touching.second(k);
            double wx = (b < 0 ? 0 : bodies.vx(b)) - bodies.vx(a);
            double wy = (b < 0 ? 0 : bodies.vy(b)) - bodies.vy(a);
            double separating = wx * touching.normalX(k) + wy * touching.normalY(k);
            solver.measured(k, separating + Math.max(0, touching.firstGap(k)) / dt);
            fastest = Math.max(fastest, Math.max(Math.abs(bodies.vx(a)), Math.abs(bodies.vy(a))));
        }
        if (solve(holding, bodies, ROUNDING * fastest) > 0) {
            pushes.pushHolding(bodies, dt);
        }
    }

    /**
     * The share of what forces give in a tick by which the bodies of a heap at rest may move for what its impulses miss; 0 for large heaps
     * that were not solved directly in this tick.
     */
    double creep() {
        if (touching.size() < ImpulseSolver.MANY) {
            return CREEP;
        }
        return isQuiet ? CREEP_OF_MANY : 0;
    }

    /** Takes from every pair that touches the closing speed that the end of the tick has left it. */
    void settle(Bodies bodies) {
        if (touching.size() == 0) {
            return;
        }
        gather(bodies);
        pushes.pushSettling(bodies);
        double rounding = measureSpeeds(bodies);
        if (solve(settling, bodies, rounding) > 0) {
            pushes.pushSettling(bodies);
        }
        for (int k = 0; k < touching.size(); k++) {
            touching.setSettling(k, 0);
        }
        for (int s = 0; s < solver.size(); s++) {
            touching.setSettling(settled[s], solver.impulse(s));
        }
    }

    /**
     * Whether a contact, as it is now, has been held through the tick. Who arrives at its very end may overlap by rounding and be held off by
     * that; he has his bounce in the next tick.
     */
    private boolean isHeld(Bodies bodies, int k) {
        int a = touching.first(k);
        int b = touching.second(k);
        double held = touching.holding(k);
        return held > 0
                && (held * contact.inverseMass > ARRIVING * contact.closingSpeed(bodies, a, b)
                        || isMassless(bodies, a)
                        || isMassless(bodies, b));
    }

    private static boolean isMassless(Bodies bodies, int i) {
        return i >= 0 && bodies.mass(i) == 0 && !bodies.isFixed(i);
    }

    private int solve(HeapSolver heap, Bodies bodies, double rounding) {
        double tolerance = TOLERANCE * solver.size();
        int most = mostRounds(solver.size());
        return isQuiet
                ? solver.solveDirectly(heap, bodies, tolerance, rounding, most)
                : solver.solve(tolerance, rounding, most);
    }

    /** While a heap still falls, each tick asks for other impulses, and rounds that leave some of them out calm it sooner. */
    private boolean isQuiet(Bodies bodies, double dt) {
        boolean many = touching.size() >= ImpulseSolver.MANY;
        if (many) {
            spins.measure(bodies);
        }
        double moving = 0;
        double falling = 0;
        for (int k = 0; k < touching.size(); k++) {
            int a = touching.first(k);
            int b = touching.second(k);
            moving += movingAtStart(bodies, k, many && b >= 0 ? spins.of(bodies.isFixed(a) ? b : a) : 0);
            falling += Paths.acceleration(bodies, a, b) * dt;
        }
        return moving <= QUIET * falling;
    }

    /**
     * How fast two partners moved past each other at the start of the tick, before forces drew anyone into a wall, beyond what turns all
     * their heap.
     */
    private double movingAtStart(Bodies bodies, int k, double spin) {
        int a = touching.first(k);
        int b = touching.second(k);
        double wx = (b < 0 ? 0 : paths.vxAt(bodies, b, 0)) - paths.vxAt(bodies, a, 0);
        double wy = (b < 0 ? 0 : paths.vyAt(bodies, b, 0)) - paths.vyAt(bodies, a, 0);
        double turned = spin == 0 ? 0 : spin * (bodies.radius(a) + bodies.radius(b));
        return Math.abs(wx + turned * touching.normalY(k)) + Math.abs(wy - turned * touching.normalX(k));
    }

    private int mostRounds(int contacts) {
        int rounds = isSolvedInPart(contacts)
                ? Math.max(FEWEST_ROUNDS, contacts / CONTACTS_PER_ROUND)
                : ROUNDS_PER_CONTACT * contacts;
        return Math.min(rounds, MOST_ROUNDS);
    }

    /** Whether the heap is a large one that moves, and nobody in it is deep in another. */
    private boolean isSolvedInPart(int contacts) {
        return !isQuiet && !isPressed && contacts >= ImpulseSolver.MANY;
    }

    /** Measures how much each pair ends too deep; the speed that need not be found is returned. */
    private double measureGaps(Bodies bodies, double dt) {
        double farthest = 0;
        double fastest = 0;
        double moving = 0;
        for (int k = 0; k < touching.size(); k++) {
            int a = touching.first(k);
            int b = touching.second(k);
            solver.measured(k, (contact.gapNow(bodies, a, b) - Math.min(0, touching.firstGap(k))) / dt);
            farthest = Math.max(farthest, Math.max(Math.abs(bodies.x(a)), Math.abs(bodies.y(a))));
            if (!solver.isAlone(k)) {
                fastest = Math.max(fastest, Math.max(Math.abs(bodies.vx(a)), Math.abs(bodies.vy(a))));
                moving = Math.max(moving, moving(bodies, a, b));
            }
        }
        return Math.max(ROUNDING * farthest / dt, Math.max(MOVING * moving, FLYING * fastest));
    }

    /** How fast two partners move past each other. */
    private static double moving(Bodies bodies, int a, int b) {
        double wx = (b < 0 ? 0 : bodies.vx(b)) - bodies.vx(a);
        double wy = (b < 0 ? 0 : bodies.vy(b)) - bodies.vy(a);
        return Math.abs(wx) + Math.abs(wy);
    }

    private double measureSpeeds(Bodies bodies) {
        double fastest = 0;
        double moving = 0;
        for (int s = 0; s < solver.size(); s++) {
            int a = touching.first(settled[s]);
            int b = touching.second(settled[s]);
            double wx = (b < 0 ? 0 : bodies.vx(b)) - bodies.vx(a);
            double wy = (b < 0 ? 0 : bodies.vy(b)) - bodies.vy(a);
            solver.measured(s, wx * settledX[s] + wy * settledY[s]);
            if (!solver.isAlone(s)) {
                fastest = Math.max(fastest, Math.max(Math.abs(bodies.vx(a)), Math.abs(bodies.vy(a))));
                moving = Math.max(moving, moving(bodies, a, b));
            }
        }
        return Math.max(MOVING * moving, FLYING * fastest);
    }

    /** Collects the contacts that are closed now and did not come here at speed: those have their bounce in the next tick. */
    private void gather(Bodies bodies) {
        if (touching.size() > settled.length) {
            settled = new int[Math.max(touching.size(), 2 * settled.length)];
            settledX = new double[settled.length];
            settledY = new double[settled.length];
        }
        solver.begin(touching.size(), bodies);
        for (int k = 0; k < touching.size(); k++) {
            int a = touching.first(k);
            int b = touching.second(k);
            contact.fillNow(bodies, a, b);
            double size = bodies.radius(a) + (b < 0 ? 0 : bodies.radius(b));
            boolean closed = contact.gap <= ImpactPredictor.CLOSED * size;
            if (closed && (isHeld(bodies, k) || approach.isGentleNow(bodies, a, b, contact))) {
                settled[solver.size()] = k;
                settledX[solver.size()] = contact.nx;
                settledY[solver.size()] = contact.ny;
                solver.add(a, b, contact.nx, contact.ny, touching.settling(k));
            }
        }
    }
}

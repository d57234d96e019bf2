package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.benchmarks.reference.Fraction;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.WorldSpec.Integration;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.diagnostics.Drift;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * Runs a hard input and checks what the case asks for, by the names in its {@code check}. Every run has a minute: what
 * does not end by then has failed.
 */
final class RobustRun {
    private static final long PATIENCE_SECONDS = 60;
    private static final int ORBITS = 10;
    private static final long BILLION = 1_000_000_000;

    private final RobustCase input;
    private final RobustScene scene;
    private final int ticks;
    private final List<String> broken = new ArrayList<>();
    private final List<String> facts = new ArrayList<>();

    /**
     * One input.
     *
     * @param contacts how they are found, where it has any
     * @param mostTicks at which a run ends, whatever the case says
     */
    RobustRun(RobustCase input, ContactMode contacts, int mostTicks) {
        this.input = input;
        this.scene = new RobustScene(input, contacts);
        this.ticks = Math.min(input.ticks(), mostTicks);
    }

    RobustRow run() {
        CompletableFuture<RobustRow> outcome = new CompletableFuture<>();
        var thread = new Thread(() -> outcome.complete(judged()), "robust-" + input.id());
        thread.setDaemon(true);
        thread.start();
        try {
            return outcome.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (TimeoutException e) {
            return failed("it had not ended after " + PATIENCE_SECONDS + " s");
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return failed("interrupted");
        } catch (ExecutionException e) {
            return failed(String.valueOf(e.getCause()));
        }
    }

    private RobustRow failed(String why) {
        return new RobustRow(input.id(), RobustRow.FAILED, why);
    }

    private RobustRow judged() {
        try {
            check();
        } catch (RuntimeException | StackOverflowError e) {
            broken.add(e instanceof IllegalArgumentException ? "refused: " + e.getMessage() : "stopped: " + e);
        }
        String outcome = String.join("; ", broken.isEmpty() ? facts : broken);
        return broken.isEmpty() ? new RobustRow(input.id(), RobustRow.OK, outcome) : failed(outcome);
    }

    private void check() {
        if (input.asks("time_at_1e9_ticks")) {
            checkTime();
        } else if (input.asks("throws")) {
            checkRefusals();
        } else if (input.asks("throws_or_reverses")) {
            checkReversal();
        } else if (input.asks("bitwise_unchanged")) {
            checkUnchanged();
        } else if (input.asks("bitwise_equal")) {
            checkRepeats();
        } else {
            checkMotion();
        }
    }

    // --- what time it is ---

    /** Ticks a world without bodies that often: nothing else moves its clock. */
    private void checkTime() {
        World world = new World(WorldSpec.builder().build());
        while (world.tick() < BILLION) {
            world.step();
        }
        double asked = input.asked("time_at_1e9_ticks");
        double ulps = Math.abs(world.time() - asked) / Math.ulp(asked);
        require(ulps <= 1, "the clock is off by %.0f ulp after 1e9 ticks", ulps);
        fact("the clock says %s after 1e9 ticks, off by %.0f ulp", world.time(), ulps);
    }

    // --- what is refused ---

    private void checkRefusals() {
        int tried = 0;
        for (double value : input.values()) {
            List<Runnable> attempts = input.id().startsWith("dt")
                    ? List.of(() -> WorldSpec.builder().dt(value).build())
                    : bodiesWith(value);
            for (Runnable attempt : attempts) {
                tried++;
                require(refuses(attempt), "%s was taken", value);
            }
        }
        fact("%d of %d refused by IllegalArgumentException", tried, tried);
    }

    private static List<Runnable> bodiesWith(double value) {
        List<Runnable> attempts = new ArrayList<>();
        attempts.add(() -> BodyDef.planet(0, 0, value, 1));
        attempts.add(() -> BodyDef.planet(0, 0, 1, value));
        if (!Double.isFinite(value)) { // a place or a velocity of −1 is as good as any
            attempts.add(() -> BodyDef.planet(value, 0, 1, 1));
            attempts.add(() -> BodyDef.planet(0, value, 1, 1));
            attempts.add(() -> BodyDef.planet(0, 0, 1, 1).moving(value, 0));
            attempts.add(() -> BodyDef.planet(0, 0, 1, 1).moving(0, value));
        }
        return attempts;
    }

    private static boolean refuses(Runnable attempt) {
        try {
            attempt.run();
            return false;
        } catch (IllegalArgumentException e) {
            return true;
        }
    }

    private void checkReversal() {
        try {
            WorldSpec.builder().dt(scene.dt()).build();
            broken.add("a tick of " + scene.dt() + " was taken");
        } catch (IllegalArgumentException e) {
            fact("refused: %s", String.valueOf(e.getMessage()));
        }
    }

    // --- what stays the same ---

    private void checkUnchanged() {
        World world = scene.world(Integration.VELOCITY_VERLET);
        WorldSnapshot before = world.snapshot();
        int steps = scene.dt() == 0 ? 10 : ticks;
        stepAll(world, steps);
        WorldSnapshot after = world.snapshot();
        for (int i = 0; i < before.count(); i++) {
            require(
                    before.x(i) == after.x(i)
                            && before.y(i) == after.y(i)
                            && before.vx(i) == after.vx(i)
                            && before.vy(i) == after.vy(i),
                    "body %d moved",
                    i);
        }
        fact("no bit changed in %d ticks", steps);
    }

    private void checkRepeats() {
        int runs = 0;
        for (Integration integration : Integration.values()) {
            long first = hashOf(integration);
            require(hashOf(integration) == first, "%s gave two different states", integration);
            runs++;
        }
        fact("%d methods gave the same bits twice; a world has one thread", runs);
    }

    private long hashOf(Integration integration) {
        World world = scene.world(integration);
        stepAll(world, ticks);
        return world.stateHash();
    }

    // --- what moves ---

    private void checkMotion() {
        List<Integration> methods = needsAdaptive()
                ? List.of(Integration.ADAPTIVE)
                : input.dt() != null
                        ? List.of(Integration.VELOCITY_VERLET, Integration.ADAPTIVE)
                        : List.of(Integration.VELOCITY_VERLET);
        for (Integration method : methods) {
            checkMotion(scene.world(method));
        }
        if (input.id().equals("dt-huge")) {
            World pile = scene.pileInABox();
            checkMotion(pile);
            require(Figures.allInside(pile.snapshot(), RobustScene.BOX), "a disc went through a wall");
        }
    }

    /** Orbits that must close and points that meet are the adaptive method's. */
    private boolean needsAdaptive() {
        return input.asks("separation_after_10_periods") || input.collisionTime() > 0;
    }

    private void checkMotion(World world) {
        int bodies = world.count();
        checkAccelerations(world.snapshot());
        double fastest = Figures.fastest(world.snapshot());
        Conserved start = world.conserved();
        double worstOverlap = 0;
        int steps = steps();
        for (int done = 0; done < steps; done++) {
            world.step();
            if (done % 10 == 0 || done == steps - 1) {
                worstOverlap = input.asks("overlap_max")
                        ? Math.max(worstOverlap, Figures.overlap(world.snapshot(), input.uniformG() != null))
                        : 0;
            }
        }
        WorldSnapshot end = world.snapshot();
        requireFinite(end);
        checkEnd(end, worstOverlap);
        if (world.spec().integration() == Integration.ADAPTIVE) {
            fact(
                    "the energy is off by %.1e, points bounced %d times, %.3g of time was lost",
                    Drift.between(start, world.conserved()).energy().orElse(Double.NaN),
                    world.pointBounces(),
                    world.lostTime());
        }
        if (end.count() < bodies) {
            fact("%d of %d bodies left the world", bodies - end.count(), bodies);
        }
        fact(
                "%s: finite after %d ticks of %s, largest speed %.3g before and %.3g after",
                nameOf(world.spec().integration()),
                steps,
                Fraction.format(world.spec().dt()),
                fastest,
                Figures.fastest(end));
    }

    private void checkAccelerations(WorldSnapshot start) {
        if (input.asks("acceleration")) {
            for (int i = 0; i < start.count(); i++) {
                double[] asked =
                        RobustCase.numbers(input.check().get("acceleration").get(i));
                require(
                        start.ax(i) == asked[0] && start.ay(i) == asked[1],
                        "body %d is accelerated by (%s, %s)",
                        i,
                        start.ax(i),
                        start.ay(i));
            }
        }
        if (input.asks("true_acceleration")) {
            double asked = RobustCase.numbers(input.check().get("true_acceleration"))[0];
            double is = start.ax(0);
            require(is == 0 || Math.abs(is / asked - 1) < 1e-12, "the acceleration is %s, not %s or 0", is, asked);
            fact("the acceleration is %s where %s is true", is, asked);
        }
    }

    private void checkEnd(WorldSnapshot end, double overlap) {
        if (input.asks("momentum")) {
            double[] asked = RobustCase.numbers(input.check().get("momentum"));
            require(
                    Math.hypot(Figures.momentumX(end) - asked[0], Figures.momentumY(end) - asked[1]) <= 1e-15,
                    "the momentum is (%s, %s)",
                    Figures.momentumX(end),
                    Figures.momentumY(end));
        }
        if (input.asks("kinetic_energy_max")) {
            double energy = Figures.kineticEnergy(end);
            require(energy <= input.asked("kinetic_energy_max"), "the kinetic energy rose to %.2e", energy);
        }
        if (input.asks("speeds")) {
            double[] asked = RobustCase.numbers(input.check().get("speeds"));
            for (int i = 0; i < asked.length; i++) {
                require(Figures.speed(end, i) == asked[i], "body %d is at speed %s", i, Figures.speed(end, i));
            }
        }
        if (input.asks("overlap_max")) {
            require(overlap <= input.asked("overlap_max"), "they overlap by %.2e", overlap);
            fact("they overlap by %.2e", overlap);
        }
        if (input.asks("separation_after_10_periods")) {
            checkSeparation(end);
        }
    }

    private void checkSeparation(WorldSnapshot end) {
        double off = Math.abs(end.distance(0, 1) - input.asked("separation_after_10_periods"));
        double limit = input.asked(
                input.asks("separation_tol_local_origin")
                        ? "separation_tol_local_origin"
                        : "separation_tol_absolute_coordinates");
        require(off <= limit, "the separation is off by %.1e after %d periods", off, ORBITS);
        fact("the separation is off by %.1e after %d periods", off, ORBITS);
    }

    private int steps() {
        if (input.asks("separation_after_10_periods")) {
            return (int) Math.round(ORBITS * input.period() / scene.dt());
        }
        if (input.collisionTime() > 0) {
            return (int) Math.ceil(2 * input.collisionTime() / scene.dt()); // through the collision and as long beyond
        }
        return scene.dt() > 1 ? Math.min(ticks, 10) : ticks;
    }

    // --- what is said ---

    private void requireFinite(WorldSnapshot now) {
        for (int i = 0; i < now.count(); i++) {
            double sum = now.x(i) + now.y(i) + now.vx(i) + now.vy(i) + now.ax(i) + now.ay(i);
            require(Double.isFinite(sum), "body %d is not finite", i);
        }
    }

    private static String nameOf(Integration integration) {
        return Arrays.stream(Method.values())
                .filter(method -> method.integration() == integration)
                .map(Method::label)
                .findFirst()
                .orElse(integration.name());
    }

    private static void stepAll(World world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.step();
        }
    }

    private void require(boolean holds, String otherwise, Object... figures) {
        if (!holds) {
            broken.add(String.format(Locale.ROOT, otherwise, figures));
        }
    }

    private void fact(String sentence, Object... figures) {
        facts.add(String.format(Locale.ROOT, sentence, figures));
    }
}

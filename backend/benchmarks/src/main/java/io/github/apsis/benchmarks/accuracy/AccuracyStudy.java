package io.github.apsis.benchmarks.accuracy;

import io.github.apsis.benchmarks.ContactMode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;

/** Runs every case of a folder over all settings, with the peer right after each, and writes what came out. */
public final class AccuracyStudy {
    private static final int TIMED_PERIODS = 100;
    private static final int LONG_PERIODS = 10_000;
    private static final int SHORT_PERIODS = 11;
    private static final int SHORT_FORCE_BODIES = 1000;
    private static final double[] THETAS = {0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0};
    private static final double[] FEW_THETAS = {0.3, 0.5, 0.7, 0.9};
    private static final long WARM_NANOS = 200_000_000;
    private static final String LONG_CASE = "figure8";

    private final Options options;
    private final Consumer<String> progress;
    private final Results results = new Results();

    /**
     * What to run.
     *
     * @param cases a folder in the reference format; null for the cases that come with the program
     * @param ids of the cases to run; empty for all
     * @param python that may have REBOUND
     */
    public record Options(@Nullable Path cases, List<String> ids, Ladder ladder, String python) {
        Predicate<String> wanted() {
            return id -> ids.isEmpty() || ids.contains(id);
        }

        boolean isShort() {
            return ladder.thoroughness() == Ladder.Thoroughness.SHORT;
        }

        /** Whether nothing was left out by name: only then the runs that belong to no case are worth their time. */
        boolean isWhole() {
            return ids.isEmpty() && !isShort() && ladder.only().size() == Method.values().length && ladder.dt() == null;
        }
    }

    /**
     * A study.
     *
     * @param progress is told each step, and each file that cannot be used
     */
    public AccuracyStudy(Options options, Consumer<String> progress) {
        this.options = options;
        this.progress = progress;
    }

    /** What came out: the tables that have rows, as CSV; a line about them; and whether all is well. */
    public record Outcome(List<String> tables, String summary, boolean allWell) {}

    /**
     * Runs everything.
     *
     * @param out where CSVs, plots and the report go; null to write nothing
     * @throws IllegalArgumentException when there is nothing to run
     */
    public Outcome run(@Nullable Path out) throws IOException {
        Path cases = options.cases();
        ReferenceFolder folder = cases == null
                ? ReferenceFolder.shipped(options.wanted())
                : ReferenceFolder.read(cases, options.wanted());
        requireSomething(folder);
        Optional<Rebound> peer = Rebound.of(options.python(), options.ladder().thoroughness());
        progress.accept(peer.map(found -> "REBOUND " + found.version() + " runs beside us")
                .orElse("no REBOUND: '" + options.python() + "' cannot import it; --python names another"));
        refuse(folder);
        runOrbits(folder, peer);
        runForces(folder, peer);
        runRobust(folder);
        if (options.isWhole()) {
            runLong(folder, peer);
            runSolarSystem(peer);
        }
        if (out != null) {
            new AccuracyReport(results, options, peer.map(Rebound::version)).write(out, progress);
        }
        return new Outcome(results.tables(), results.summary(), results.bad() == 0);
    }

    private void requireSomething(ReferenceFolder folder) {
        if (folder.orbits().isEmpty()
                && folder.forces().isEmpty()
                && folder.robust().isEmpty()
                && folder.brokenRobust().isEmpty()
                && folder.refusals().isEmpty()) {
            throw new IllegalArgumentException(
                    options.ids().isEmpty()
                            ? "There are no nbody, force or robust cases in that folder."
                            : "There is no such case: " + String.join(", ", options.ids()) + ".");
        }
    }

    private void refuse(ReferenceFolder folder) {
        for (ReferenceFolder.Refusal refusal : folder.refusals()) {
            progress.accept(refusal.file() + " " + refusal.status());
            results.orbits.add(OrbitRow.without(refusal.id(), refusal.status()));
        }
        results.contacts.addAll(folder.contacts());
        if (!folder.contacts().isEmpty()) {
            progress.accept(folder.contacts().size() + " contact cases are not run here");
        }
    }

    // --- orbits ---

    private void runOrbits(ReferenceFolder folder, Optional<Rebound> peer) throws IOException {
        Map<String, Integer> sizes = new HashMap<>();
        folder.orbits().stream().findFirst().ifPresent(this::warmUp);
        for (NBodyCase whole : folder.orbits()) {
            NBodyCase orbit = whole.until(
                    options.isShort()
                            ? whole.within(SHORT_PERIODS)
                            : folder.tolerances().lastOf(whole.id()).orElse(whole.end()));
            sizes.put(orbit.id(), orbit.bodies().size());
            double horizon = orbit.within(TIMED_PERIODS);
            List<Setting> settings = options.ladder().of(orbit);
            progress.accept("%s: %d settings".formatted(orbit.id(), settings.size()));
            for (Setting setting : settings) {
                results.orbits.add(row(orbit, setting, horizon, folder.tolerances()));
            }
            if (peer.isPresent()) {
                results.peerOrbits.addAll(peer.get().orbits(orbit, horizon, Ladder.ROOM));
            }
        }
        results.stepCosts.addAll(StepCost.of(results.orbits, results.peerOrbits, sizes));
    }

    /** All methods first, so that the one which is measured first meets the same compiled code as the last. */
    private void warmUp(NBodyCase orbit) {
        for (Setting setting : options.ladder().of(orbit)) {
            try {
                new OrbitRun(orbit, setting).warmUp(WARM_NANOS);
            } catch (RuntimeException e) {
                // It will be a row that has failed.
            }
        }
    }

    private OrbitRow row(NBodyCase orbit, Setting setting, double horizon, Tolerances tolerances) {
        try {
            var run = new OrbitRun(orbit, setting);
            OrbitErrors errors = run.errors();
            List<Tolerances.Limit> limits = tolerances.of(orbit.id(), setting);
            String status = Verdict.of(errors, limits);
            if (Verdict.swings(errors, limits)) {
                results.swinging.add(orbit.id() + " by " + setting);
            }
            return OrbitRow.of(orbit, setting, run.cpuMicrosPerUnit(horizon), errors, status);
        } catch (RuntimeException e) { // the engine refuses, or stops, or has a bug: the other rows are worth having
            return OrbitRow.failed(
                    orbit.id(),
                    setting.method().label(),
                    setting.dt(),
                    setting.tolerance(),
                    Verdict.FAILED + reason(e));
        }
    }

    private static String reason(RuntimeException e) {
        return e instanceof IllegalArgumentException || e instanceof IllegalStateException
                ? String.valueOf(e.getMessage())
                : e.toString();
    }

    // --- the rest ---

    private void runForces(ReferenceFolder folder, Optional<Rebound> peer) throws IOException {
        for (ForceCase bodies : folder.forces()) {
            if (options.isShort() && bodies.count() > SHORT_FORCE_BODIES) {
                progress.accept(bodies.id() + ": left out of a short run");
                continue;
            }
            progress.accept(bodies.id() + ": direct sum and tree");
            try {
                var run = new ForceRun(bodies);
                results.forces.add(run.direct());
                for (double theta : options.isShort() ? FEW_THETAS : THETAS) {
                    results.forces.add(run.tree(theta));
                }
            } catch (RuntimeException e) {
                results.orbits.add(OrbitRow.without(bodies.id(), Verdict.FAILED + reason(e)));
            }
            if (peer.isPresent()) {
                results.forces.addAll(peer.get().forces(bodies.file()));
            }
        }
    }

    private void runRobust(ReferenceFolder folder) {
        int mostTicks = options.isShort() ? 150 : Integer.MAX_VALUE;
        if (!folder.robust().isEmpty()) {
            progress.accept(folder.robust().size() + " hard inputs");
        }
        for (RobustRow broken : folder.brokenRobust()) {
            progress.accept(broken.id() + ": " + broken.outcome());
            results.robust.add(broken);
        }
        for (RobustCase input : folder.robust()) {
            results.robust.add(new RobustRun(input, ContactMode.TICK, mostTicks).run());
        }
    }

    private void runLong(ReferenceFolder folder, Optional<Rebound> peer) throws IOException {
        Optional<NBodyCase> found = folder.orbits().stream()
                .filter(one -> one.id().equals(LONG_CASE))
                .findFirst();
        if (found.isEmpty()) {
            return;
        }
        NBodyCase orbit = found.get();
        double end = LONG_PERIODS * orbit.period();
        progress.accept("%s: %d periods".formatted(LONG_CASE, LONG_PERIODS));
        for (Setting setting : EnergyOverTime.settings(orbit)) {
            try {
                results.energy.addAll(EnergyOverTime.of(orbit, setting, end));
            } catch (RuntimeException e) {
                progress.accept(LONG_CASE + " by " + setting + ": " + reason(e));
            }
        }
        if (peer.isPresent()) {
            results.energy.addAll(peer.get().energyOverTime(orbit.file(), end));
        }
    }

    private void runSolarSystem(Optional<Rebound> peer) throws IOException {
        progress.accept("the solar system: 1000 years");
        Path folder = Files.createTempDirectory("apsis-solar-system");
        folder.toFile().deleteOnExit(); // the last named goes first, so the folder is empty by then
        try {
            NBodyCase orbit = SolarMillennium.write(folder);
            orbit.file().toFile().deleteOnExit();
            double horizon = orbit.within(TIMED_PERIODS);
            for (Setting setting : SolarMillennium.settings()) {
                results.solarSystem.add(row(orbit, setting, horizon, new Tolerances()));
            }
            if (peer.isPresent()) {
                results.solarSystem.addAll(peer.get().orbits(orbit, horizon, 1)); // steps of days
            }
        } catch (RuntimeException e) {
            progress.accept("the solar system: " + reason(e));
        }
    }
}

package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.contacts.ContactStudy.Length;
import io.github.apsis.benchmarks.discs.Contender;
import io.github.apsis.benchmarks.discs.DiscScene;
import io.github.apsis.benchmarks.discs.DiscScenes;
import io.github.apsis.benchmarks.discs.DiscScenes.Target;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** The same scenes in our modes and in other engines, one after the other in this JVM. */
final class Comparison {
    private static final long PATIENCE_SECONDS = 300; // by the clock, of one engine in one scene
    private static final int MOST_SECONDS = 60; // of CPU time: dyn4j and JBox2D need 30 for a pile of 5000
    private static final int FEW_SECONDS = 15;
    private static final int[] TICKS_PER_UNIT = {50, 100, 200, 400, 800, 1600};
    private static final List<String> TICK_CASES = List.of("pair-head-on-e10", "pair-oblique-e10", "gas100");
    private static final double TICK_CASE_END = 1; // later a gas amplifies whatever it is given

    private final Consumer<String> progress;
    final List<SceneRow> scenes = new ArrayList<>();
    final List<BulletRow> bullets = new ArrayList<>();
    final List<CradleRow> cradles = new ArrayList<>();
    final List<TickRow> ticks = new ArrayList<>();
    /** What an engine did not do, one line each. */
    final List<String> failures = new ArrayList<>();

    Comparison(Consumer<String> progress) {
        this.progress = progress;
    }

    void run(Length length, List<ContactCase> cases) {
        ticks(cases);
        trials(Contender.FEW, new SceneTrial(DiscScenes.chain(), 450, 90, FEW_SECONDS));
        for (Contender engine : Contender.FEW) {
            cradles(engine);
        }
        for (Contender engine : Contender.BULLETS) {
            for (Target target : Target.values()) {
                tryTo("bullets in " + engine.label(), () -> BulletRow.of(target, engine), bullets);
            }
        }
        gases(length);
        piles(length);
    }

    private void ticks(List<ContactCase> cases) {
        for (ContactCase known : cases) {
            if (!TICK_CASES.contains(known.id())) {
                continue;
            }
            int sample = sampleAt(known, TICK_CASE_END);
            for (Contender engine : Contender.FEW) {
                progress.accept(known.id() + ": " + engine.label());
                for (int perUnit : TICKS_PER_UNIT) {
                    tryTo(
                            known.id() + " in " + engine.label(),
                            () -> TickRow.of(known, sample, engine, perUnit),
                            ticks);
                }
            }
        }
    }

    private static int sampleAt(ContactCase known, double time) {
        for (int k = 0; k < known.samples().size(); k++) {
            if (known.samples().get(k).time() == time) {
                return k;
            }
        }
        throw new IllegalArgumentException(known.id() + " has no sample at " + time);
    }

    private void cradles(Contender engine) {
        for (int count : new int[] {5, 20}) {
            for (double gap : new double[] {0, 0.05}) {
                DiscScene scene = DiscScenes.cradle(count, gap);
                tryTo(scene.name() + " in " + engine.label(), () -> CradleRow.of(scene, engine), cradles);
            }
        }
    }

    private void gases(Length length) {
        if (length == Length.SHORT) {
            trials(Contender.CROWDS, new SceneTrial(DiscScenes.gas(1000), 300, 100, FEW_SECONDS));
        } else {
            trials(Contender.CROWDS, new SceneTrial(DiscScenes.gas(1000), 1500, 300, MOST_SECONDS));
            trials(Contender.CROWDS, new SceneTrial(DiscScenes.gas(5000), 600, 150, MOST_SECONDS));
        }
    }

    private void piles(Length length) {
        if (length == Length.SHORT) {
            trials(Contender.PILES, new SceneTrial(DiscScenes.pile(200), 600, 480, FEW_SECONDS));
        } else {
            trials(Contender.PILES, new SceneTrial(DiscScenes.pile(1000), 1500, 1200, MOST_SECONDS));
            trials(Contender.PILES, new SceneTrial(DiscScenes.pile(5000), 450, 360, MOST_SECONDS));
        }
    }

    private void trials(List<Contender> engines, SceneTrial trial) {
        engines.forEach(engine -> scene(trial, engine));
    }

    private void scene(SceneTrial trial, Contender engine) {
        String name = "%s of %d in %s"
                .formatted(trial.scene().name(), trial.scene().discs().size(), engine.label());
        progress.accept(name);
        try {
            scenes.add(Patience.of(() -> trial.run(engine), PATIENCE_SECONDS));
        } catch (IllegalStateException e) { // what others do is worth having
            failures.add(name + ": " + e.getMessage());
            scenes.add(SceneRow.failed(trial.scene(), engine, String.valueOf(e.getMessage())));
        }
    }

    private <T> void tryTo(String what, Supplier<T> work, List<T> into) {
        try {
            into.add(Patience.of(work::get, PATIENCE_SECONDS));
        } catch (IllegalStateException e) {
            failures.add(what + ": " + e.getMessage());
        }
    }
}

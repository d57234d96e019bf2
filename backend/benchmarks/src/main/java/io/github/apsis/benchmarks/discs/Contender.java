package io.github.apsis.benchmarks.discs;

import io.github.apsis.benchmarks.ContactMode;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.dyn4j.dynamics.ContinuousDetectionMode;

/** An engine in one of its settings, as a way to run a scene. */
public enum Contender {
    APSIS_TICK("apsis", "Apsis, tick", scene -> new ApsisDiscs(scene, ContactMode.TICK)),
    APSIS_EXACT("apsis-exact", "Apsis, exact", scene -> new ApsisDiscs(scene, ContactMode.EXACT)),
    DYN4J(
            "dyn4j",
            "dyn4j 6.0.0",
            scene -> new Dyn4jDiscs(scene, ContinuousDetectionMode.ALL, Dyn4jDiscs.Speeds.CLAMPED)),
    DYN4J_BULLETS_ONLY(
            "dyn4j-bullets-only",
            "dyn4j 6.0.0, bullets only",
            scene -> new Dyn4jDiscs(scene, ContinuousDetectionMode.BULLETS_ONLY, Dyn4jDiscs.Speeds.CLAMPED)),
    DYN4J_DISCRETE(
            "dyn4j-discrete",
            "dyn4j 6.0.0, discrete",
            scene -> new Dyn4jDiscs(scene, ContinuousDetectionMode.NONE, Dyn4jDiscs.Speeds.CLAMPED)),
    DYN4J_ANY_SPEED(
            "dyn4j-any-speed",
            "dyn4j 6.0.0, no speed limit",
            scene -> new Dyn4jDiscs(scene, ContinuousDetectionMode.ALL, Dyn4jDiscs.Speeds.ANY)),
    JBOX2D("jbox2d", "JBox2D 2.2.1.1", JBox2dDiscs::new);

    public static final List<Contender> CROWDS = besideUs(DYN4J, DYN4J_DISCRETE, JBOX2D);
    /** Our contacts by ticks, and all that others offer. */
    public static final List<Contender> BY_TICKS =
            List.of(APSIS_TICK, DYN4J, DYN4J_BULLETS_ONLY, DYN4J_DISCRETE, JBOX2D);

    public static final List<Contender> PILES = besideUs(DYN4J_BULLETS_ONLY, JBOX2D);
    public static final List<Contender> FEW = besideUs(DYN4J, JBOX2D);
    public static final List<Contender> BULLETS = besideUs(DYN4J, DYN4J_ANY_SPEED, JBOX2D);

    private final String id;
    private final String label;
    private final Function<DiscScene, DiscEngine> engine;

    Contender(String id, String label, Function<DiscScene, DiscEngine> engine) {
        this.id = id;
        this.label = label;
        this.engine = engine;
    }

    private static List<Contender> besideUs(Contender... others) {
        List<Contender> all = new ArrayList<>(List.of(APSIS_TICK, APSIS_EXACT));
        all.addAll(List.of(others));
        return all;
    }

    /** For programs: {@code dyn4j-discrete}. */
    public String id() {
        return id;
    }

    /** For people: {@code dyn4j 6.0.0, discrete}. */
    public String label() {
        return label;
    }

    public boolean isOurs() {
        return this == APSIS_TICK || this == APSIS_EXACT;
    }

    public DiscEngine run(DiscScene scene) {
        return engine.apply(scene);
    }
}

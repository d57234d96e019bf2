package io.github.apsis.benchmarks.steering;

import io.github.apsis.engine.steering.SteeringSpec;
import io.github.apsis.engine.steering.SteeringSpec.Arrival;
import io.github.apsis.engine.steering.SteeringSpec.Avoidance;
import java.util.Arrays;
import java.util.function.Function;

/** The ways to steer that are compared. */
enum Contender {
    APSIS("apsis", state -> new EnginePilot(state, SteeringSpec.DEFAULT)),
    APSIS_BRAKING("apsis-braking", state -> new EnginePilot(state, SteeringSpec.DEFAULT.arriving(Arrival.BRAKING))),
    SOURCE("source", state -> new EnginePilot(state, SteeringSpec.DEFAULT.avoiding(Avoidance.SOURCE))),
    SOURCE_SEEK_FIRST(
            "source-seek-first",
            state -> new EnginePilot(state, SteeringSpec.DEFAULT.avoiding(Avoidance.SOURCE_SEEK_FIRST))),
    GDX_PRIORITY("gdx-ai-priority", state -> new GdxPilot(state, GdxPilot.Sharing.PRIORITY)),
    GDX_BLENDED("gdx-ai-blended", state -> new GdxPilot(state, GdxPilot.Sharing.BLENDED)),
    ORCA("orca", OrcaPilot::new),
    NO_AVOIDANCE("none", state -> new EnginePilot(state, SteeringSpec.DEFAULT.avoiding(Avoidance.NONE)));

    private final String label;
    private final Function<SceneState, Pilot> maker;

    Contender(String label, Function<SceneState, Pilot> maker) {
        this.label = label;
        this.maker = maker;
    }

    /** @throws IllegalArgumentException when there is none of that name */
    static Contender named(String label) {
        return Arrays.stream(values())
                .filter(contender -> contender.label.equals(label))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("there is no method " + label + "; there are "
                        + Arrays.stream(values()).map(Contender::label).toList()));
    }

    String label() {
        return label;
    }

    Pilot pilot(SceneState state) {
        return maker.apply(state);
    }
}

package io.github.apsis.engine.stepping;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.ReferenceCase;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;

/** Exact contacts under gravity. */
class EventStepperTest {
    private static WorldSpec.Builder exact(double restitution) {
        return WorldSpec.builder().gravity(1).adaptive(1e-16).exactContacts(restitution);
    }

    @Test
    void a_ball_bounces_twenty_times_on_a_planet_when_and_as_high_as_it_should() {
        ReferenceCase drop = ReferenceCase.of("planet-drop");
        World world = drop.world(exact(0.8).build());
        List<double[]> bounces = new ArrayList<>();
        world.onBounce((time, a, b, c, impulse) -> bounces.add(new double[] {time, c}));

        run(world, 2700); // 18 s

        int k = 0;
        for (JsonNode truth : drop.node("events")) {
            // Times are wrong by 1e-14; a speed of 0.26 at the end by what that is of the gap, 1e-14 of 101.
            assertThat(bounces.get(k)[0] / truth.get("t").asDouble())
                    .as("time %d", k)
                    .isCloseTo(1, within(1e-13));
            assertThat(bounces.get(k)[1] / -truth.get("vn").asDouble())
                    .as("speed %d", k)
                    .isCloseTo(1, within(1e-11));
            k++;
        }
    }
}

package io.github.apsis.engine;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import org.junit.jupiter.api.Test;

class WorldSpecTest {
    @Test
    void with_other_threads_it_is_the_same_world() {
        WorldSpec spec = WorldSpec.builder()
                .gravity(3)
                .softening(0.1)
                .tree(0.4)
                .law(new UniformField(0, -1))
                .integration(WorldSpec.Integration.PEFRL)
                .contacts(0.5)
                .walls(Aabb.centred(10, 10), 0.7)
                .mortalShips()
                .dt(0.01)
                .seed(9)
                .maxBodies(77)
                .build();

        WorldSpec shared = spec.withThreads(3);

        assertThat(shared.threads()).isEqualTo(3);
        assertThat(shared).usingRecursiveComparison().ignoringFields("threads").isEqualTo(spec);
    }
}

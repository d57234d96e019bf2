package io.github.apsis.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.diagnostics.Conserved;
import org.junit.jupiter.api.Test;

class ElasticGasTest {
    private final World world = new ElasticGas().world(5);

    @Test
    void it_starts_at_rest_as_a_whole() {
        Conserved start = world.conserved();

        // 500 velocities, each rounded once when their mean is taken off.
        assertThat(start.momentumX() / start.momentumScale()).isCloseTo(0, within(1e-15));
        assertThat(start.momentumY() / start.momentumScale()).isCloseTo(0, within(1e-15));
    }

    @Test
    void no_number_of_contacts_changes_its_energy() {
        double energy = world.conserved().kinetic();

        step(1500);

        // Some 10 000 contacts, each of which rounds two velocities: far below 10 000 · 1e-16.
        assertThat(world.conserved().kinetic() / energy).isCloseTo(1, within(1e-12));
    }

    @Test
    void its_speeds_settle_to_maxwells() {
        step(3000);

        // In two dimensions energies of a gas in equilibrium are exponential: ⟨E²⟩ / ⟨E⟩² = 2. Uniform velocities
        // start at 1.4. 500 discs scatter by √(20/500) = 0.2; three of these.
        assertThat(energyRatio(world.snapshot())).isBetween(1.6, 2.6);
    }

    @Test
    void any_number_of_discs_has_the_same_area_to_itself() {
        for (int count : new int[] {10, 500, 5000}) {
            Scene gas = SceneCatalogue.byName("elastic-gas", count).orElseThrow();
            double side = gas.view().width() - 48; // the view shows a rim of one spacing around the box

            assertThat(side * side / count).isBetween(576.0, 1000.0); // 24², and what the last row leaves free
        }
    }

    private static double energyRatio(WorldSnapshot now) {
        double sum = 0;
        double squares = 0;
        for (int i = 0; i < now.count(); i++) {
            double energy = now.mass(i) * (now.vx(i) * now.vx(i) + now.vy(i) * now.vy(i)) / 2;
            sum += energy;
            squares += energy * energy;
        }
        return squares / now.count() / (sum / now.count() * (sum / now.count()));
    }

    private void step(int ticks) {
        for (int i = 0; i < ticks; i++) {
            world.step();
        }
    }
}

package io.github.apsis.engine.body;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.math.Rng;
import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;

class ShipColumnsTest {
    private final Bodies bodies = new Bodies();
    private final Map<Long, Double> targets = new LinkedHashMap<>(); // x by id; NaN of what is no ship
    private final Rng rng = new Rng(5);

    /** Slots are looked up in words of 64 bits: some hundred bodies, of which any may be ships. */
    @Test
    void ships_keep_what_is_theirs_while_others_come_and_go() {
        for (int round = 0; round < 2000; round++) {
            if (bodies.count() < 300 && rng.nextDouble() < 0.6) {
                add(rng.nextDouble() < 0.4);
            } else if (bodies.count() > 0) {
                remove((int) (rng.nextDouble() * bodies.count()));
            }
        }

        assertThat(bodies.count()).isGreaterThan(100);
        assertColumns();
    }

    private void add(boolean isShip) {
        int slot = bodies.add(isShip ? BodyDef.ship(0, 0, 1, 1, new ShipLimits(1, 1)) : BodyDef.planet(0, 0, 1, 1));
        double target = isShip ? rng.nextDouble() : Double.NaN;
        if (isShip) {
            bodies.setTarget(slot, target, 0);
        }
        targets.put(bodies.idValue(slot), target);
    }

    private void remove(int slot) {
        targets.remove(bodies.idValue(slot));
        bodies.remove(slot);
    }

    private void assertColumns() {
        int ships = 0;
        for (int i = 0; i < bodies.count(); i++) {
            assertThat(bodies.targetX(i)).isEqualTo(targets.get(bodies.idValue(i)));
            if (bodies.isShip(i)) {
                assertThat(bodies.ships()[ships++]).isEqualTo(i);
            }
            assertThat(bodies.shipNumber(i)).isEqualTo(bodies.isShip(i) ? ships : 0);
        }
        assertThat(bodies.ships()).hasSize(ships);
    }
}

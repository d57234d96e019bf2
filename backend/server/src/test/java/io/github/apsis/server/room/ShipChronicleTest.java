package io.github.apsis.server.room;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.server.room.ShipEvent.What;
import java.util.List;
import org.junit.jupiter.api.Test;

class ShipChronicleTest {
    private static final BodyId SHIP = new BodyId(1);
    private static final BodyId OTHER_SHIP = new BodyId(2);

    @Test
    void a_mortal_ship_that_hits_two_rocks_in_one_tick_dies_once() {
        ShipChronicle ships = chronicle(true);

        bounces(ships, 1, 3, 1, 4);

        assertThat(events(ships)).extracting(ShipEvent::what).containsExactly(What.DESTROYED);
        assertThat(events(ships)).isEmpty(); // told
    }

    @Test
    void three_mortal_ships_that_meet_in_a_row_die_once_each() {
        ShipChronicle ships = chronicle(true);
        ships.add(new BodyId(5), BodyKind.SHIP);

        bounces(ships, 1, 2, 2, 5);

        assertThat(events(ships)).extracting(ShipEvent::ship).containsExactly(SHIP, OTHER_SHIP, new BodyId(5));
    }

    @Test
    void a_ship_that_bounces_off_two_rocks_has_two_collisions() {
        ShipChronicle ships = chronicle(false);

        bounces(ships, 1, 3, 1, 4);

        assertThat(events(ships)).extracting(ShipEvent::what).containsExactly(What.COLLIDED, What.COLLIDED);
        assertThat(ships.tally().collisions()).isEqualTo(2);
    }

    private static ShipChronicle chronicle(boolean mortal) {
        ShipChronicle ships = new ShipChronicle(mortal);
        ships.add(SHIP, BodyKind.SHIP);
        ships.add(OTHER_SHIP, BodyKind.SHIP);
        ships.add(new BodyId(3), BodyKind.ASTEROID);
        ships.add(new BodyId(4), BodyKind.ASTEROID);
        return ships;
    }

    private static void bounces(ShipChronicle ships, long... pairs) {
        ships.begin(1);
        for (int i = 0; i < pairs.length; i += 2) {
            ships.listener().bounced(0, pairs[i], pairs[i + 1], 5, 60);
        }
        ships.end(1, 1 / 150.0);
    }

    private static List<ShipEvent> events(ShipChronicle ships) {
        return ships.news(1).map(ShipEvents::events).orElse(List.of());
    }
}

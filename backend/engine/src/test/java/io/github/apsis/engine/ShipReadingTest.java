package io.github.apsis.engine;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.ShipReading.Passing;
import io.github.apsis.engine.ShipReading.Threat;
import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Period;
import io.github.apsis.engine.math.Vec2;
import org.junit.jupiter.api.Test;

/** What is told of a ship that somebody looks at. All numbers can be checked by hand. */
class ShipReadingTest {
    private final Bodies bodies = new Bodies();
    private final int ship = bodies.add(BodyDef.ship(0, 0, 5, 8, new ShipLimits(120, 1000)));

    @Test
    void a_ship_without_order_and_threat_has_neither() {
        ShipReading reading = ShipReading.of(bodies, ship, null);

        assertThat(reading.target()).isEmpty();
        assertThat(reading.threat()).isEmpty();
    }

    @Test
    void the_closest_approach_is_that_of_the_course_and_not_of_the_present_velocity() {
        threatenedBy(BodyDef.asteroid(100, 30, 1, 10).moving(-10, 0));

        // 100 at 50: 2 on. There they are 30 apart, less 8 and 10.
        assertThat(ShipReading.of(bodies, ship, null).threat())
                .contains(new Threat(new BodyId(2), 1.5, new Passing(2, 12, new Vec2(80, 0), new Vec2(80, 30))));
    }

    @Test
    void two_that_would_touch_have_a_negative_gap() {
        threatenedBy(BodyDef.asteroid(100, 0, 1, 10).moving(-10, 0));

        assertThat(passing().gap()).isEqualTo(-18);
    }

    @Test
    void what_is_getting_away_is_closest_now() {
        threatenedBy(BodyDef.asteroid(-30, 0, 1, 10));

        assertThat(passing()).isEqualTo(new Passing(0, 12, new Vec2(0, 0), new Vec2(-30, 0)));
    }

    @Test
    void what_keeps_its_distance_is_closest_now() {
        threatenedBy(BodyDef.asteroid(0, 30, 1, 10).moving(40, 0));

        assertThat(passing()).isEqualTo(new Passing(0, 12, new Vec2(0, 0), new Vec2(0, 30)));
    }

    @Test
    void in_a_world_that_repeats_itself_the_nearest_image_counts() {
        threatenedBy(BodyDef.asteroid(-160, 0, 1, 10));

        // 40 ahead beyond the edge at 100.
        Passing passing = ShipReading.of(bodies, ship, new Period(Aabb.centred(100, 100)))
                .threat()
                .orElseThrow()
                .passing();
        assertThat(passing).isEqualTo(new Passing(1, -18, new Vec2(40, 0), new Vec2(40, 0)));
    }

    @Test
    void a_threat_that_has_gone_since_the_ship_last_thought_is_none() {
        threatenedBy(BodyDef.asteroid(100, 0, 1, 10));
        bodies.remove(1);

        assertThat(ShipReading.of(bodies, ship, null).threat()).isEmpty();
    }

    private void threatenedBy(BodyDef body) {
        int threat = bodies.add(body);
        bodies.setCourse(ship, 40, 0, true);
        bodies.setThreat(ship, bodies.idValue(threat), 1.5);
    }

    private Passing passing() {
        return ShipReading.of(bodies, ship, null).threat().orElseThrow().passing();
    }
}

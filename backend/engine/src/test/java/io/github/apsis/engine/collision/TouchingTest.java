package io.github.apsis.engine.collision;

import static org.assertj.core.api.Assertions.assertThat;

import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What is known of a contact when its tick begins. */
class TouchingTest {
    private static final int FLOOR = -3;

    private final Bodies bodies = new Bodies();
    private final Touching touching = new Touching();
    private final ContactGeometry upwards = new ContactGeometry(null, null);
    private int lower;
    private int upper;

    @BeforeEach
    void pile() {
        lower = bodies.add(BodyDef.asteroid(0, 1, 2, 1));
        upper = bodies.add(BodyDef.asteroid(0, 3, 2, 1));
        upwards.ny = 1;
        touching.begin(bodies);
    }

    @Test
    void a_contact_begins_with_the_impulses_of_the_last_tick_and_its_bodies_with_their_support() {
        touching.add(lower, upper, upwards);
        touching.setHolding(0, 5);
        touching.setSettling(0, 1);

        touching.begin(bodies);
        touching.add(lower, upper, upwards);

        assertThat(touching.holding(0)).isEqualTo(5);
        assertThat(touching.settling(0)).isEqualTo(1);
        assertThat(touching.support(upper)).isEqualTo(3); // (5 + 1) / 2
    }

    @Test
    void one_that_is_recalled_has_the_impulses_and_gives_the_support_of_an_earlier_tick() {
        touching.add(lower, FLOOR, upwards);
        touching.recall(bodies, lower, upper, upwards, 5, 1);
        touching.add(upper, FLOOR, upwards);

        assertThat(touching.holding(1)).isEqualTo(5);
        assertThat(touching.settling(1)).isEqualTo(1);
        assertThat(touching.support(upper)).isEqualTo(3);
        assertThat(touching.support(lower)).isEqualTo(3);
        assertThat(touching.isRecalled(0)).isFalse();
        assertThat(touching.isRecalled(1)).isTrue();
        assertThat(touching.isRecalled(2)).isFalse();

        touching.begin(bodies);
        touching.add(lower, FLOOR, upwards);
        touching.add(lower, upper, upwards);

        assertThat(touching.isRecalled(1)).isFalse();
    }

    @Test
    void one_of_the_last_tick_that_is_recalled_supports_once() {
        touching.add(lower, upper, upwards);
        touching.setHolding(0, 6);
        touching.begin(bodies);

        touching.recall(bodies, lower, upper, upwards, 5, 1);

        assertThat(touching.holding(0)).isEqualTo(6);
        assertThat(touching.support(upper)).isEqualTo(3);
    }

    @Test
    void when_it_has_shrunk_it_still_knows_who_touches() {
        for (int i = 0; i < 100; i++) {
            int other = bodies.add(BodyDef.asteroid(9, 9, 1, 1));
            touching.add(lower, other, upwards);
        }
        touching.begin(bodies);
        touching.add(lower, upper, upwards);
        touching.setHolding(0, 6);

        touching.shrink();
        touching.begin(bodies);
        touching.add(lower, FLOOR, upwards);
        touching.add(lower, upper, upwards);

        assertThat(touching.size()).isEqualTo(2);
        assertThat(touching.holding(0)).isZero();
        assertThat(touching.holding(1)).isEqualTo(6);
    }
}

package io.github.apsis.benchmarks.steering;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class OrcaTest {
    private static final double LONG = 1e6; // time: the obstacle is a cone
    private static final double EXACT = 1e-12; // some roundings of numbers about 10

    @Test
    void who_flies_at_a_rock_turns_to_its_tangent() {
        var orca = new Orca(10, 1);

        orca.keepClear(5, 0, 3, 10, 0, 10, 0, 1, LONG);
        orca.choose(10, 0);

        assertThat(orca.x()).isCloseTo(6.4, within(EXACT)); // 10 cos² α, sin α = 3/5
        assertThat(orca.y()).isCloseTo(-4.8, within(EXACT)); // −10 cos α sin α
    }

    @Test
    void two_that_meet_head_on_go_half_of_the_way_each() {
        var orca = new Orca(10, 1);

        orca.keepClear(5, 0, 3, 10, 0, 20, 0, 0.5, LONG);
        orca.choose(10, 0);

        assertThat(orca.x()).isCloseTo(6.4, within(EXACT)); // half of (12.8 − 20), from 10
        assertThat(orca.y()).isCloseTo(-4.8, within(EXACT));
    }

    @Test
    void a_rock_that_is_reached_later_than_asked_about_is_none() {
        var orca = new Orca(10, 1);

        orca.keepClear(50, 0, 3, 10, 0, 10, 0, 1, 4);
        orca.choose(10, 0);

        assertThat(orca.x()).isEqualTo(10);
        assertThat(orca.y()).isZero();
    }

    @Test
    void where_two_push_from_both_sides_it_stays_in_the_middle() {
        var orca = new Orca(10, 2);

        orca.keepClear(2, 0, 3, 0, 0, 0, 0, 1, 1);
        orca.keepClear(-2, 0, 3, 0, 0, 0, 0, 1, 1);
        orca.choose(7, 0);

        assertThat(orca.x()).isCloseTo(0, within(1e-4)); // ten times what the last halving leaves of the top speed
    }
}

package io.github.apsis.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.body.BodyKind;
import org.junit.jupiter.api.Test;

class BeltAndSwarmTest {
    private static final double GM = 240_000;

    private final World world = new BeltAndSwarm().world(3);

    @Test
    void has_a_planet_two_moons_a_belt_of_205_and_a_swarm_of_40() {
        assertThat(count(BodyKind.PLANET)).isEqualTo(3);
        assertThat(count(BodyKind.ASTEROID)).isEqualTo(205);
        assertThat(count(BodyKind.SHIP)).isEqualTo(40);
    }

    @Test
    void everything_but_the_planet_starts_on_a_circle_counter_clockwise() {
        WorldSnapshot now = world.snapshot();
        for (int i = 1; i < now.count(); i++) {
            double r = distance(now, i);
            double outwards = (now.x(i) * now.vx(i) + now.y(i) * now.vy(i)) / r;
            double around = (now.x(i) * now.vy(i) - now.y(i) * now.vx(i)) / r;

            assertThat(outwards).isCloseTo(0, within(1e-12));
            assertThat(around).isCloseTo(Math.sqrt(GM / r), within(1e-12));
        }
    }

    @Test
    void five_minutes_later_the_planet_has_its_moons_and_its_belt() {
        for (int tick = 0; tick < 300 * 150; tick++) {
            world.step();
        }

        WorldSnapshot now = world.snapshot();
        assertThat(distance(now, 0)).isZero();
        assertThat(distance(now, 1)).isBetween(140.0, 180.0);
        assertThat(distance(now, 2)).isBetween(70.0, 100.0);
        assertThat(inBelt(now)).isGreaterThan(195); // ships knock a few out
    }

    private long count(BodyKind kind) {
        return new BeltAndSwarm()
                .bodies(3).stream().filter(body -> body.def().kind() == kind).count();
    }

    private static int inBelt(WorldSnapshot now) {
        int inside = 0;
        for (int i = 0; i < now.count(); i++) {
            double r = distance(now, i);
            if (now.kind(i) == BodyKind.ASTEROID && r > 200 && r < 480) {
                inside++;
            }
        }
        return inside;
    }

    private static double distance(WorldSnapshot now, int i) {
        return Math.sqrt(now.x(i) * now.x(i) + now.y(i) * now.y(i));
    }
}

package io.github.apsis.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.scenes.Palette.Range;
import io.github.apsis.scenes.shape.AsteroidOutline;
import io.github.apsis.scenes.shape.Outline;
import java.util.Objects;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class RandomBodiesTest {
    private static final Aabb AREA = Aabb.centred(200, 100);
    private static final Palette PALETTE = new Palette(
            AREA, new Range(5, 15), new Range(2, 8), new Range(3, 9), 0.5, 40, 1.5, 6, 12, new ShipLimits(120, 2400));

    private final WorldSpec open = WorldSpec.builder().build();
    private final World world = new World(open);

    @Test
    void a_planet_is_at_rest_and_its_radius_follows_from_mass_and_density() {
        RandomBodies random = new RandomBodies(PALETTE, open, 1);
        for (int i = 0; i < 100; i++) {
            BodyDef planet = random.planet(world.snapshot()).orElseThrow().def();

            assertThat(planet.kind()).isEqualTo(BodyKind.PLANET);
            assertThat(planet.vx()).isZero();
            assertThat(planet.vy()).isZero();
            assertThat(planet.radius()).isBetween(5.0, 15.0);
            assertThat(planet.mass() / (Math.PI * planet.radius() * planet.radius()))
                    .isBetween(2.0, 8.0);
        }
    }

    @Test
    void an_asteroid_moves_and_weighs_its_area_times_the_density() {
        RandomBodies random = new RandomBodies(PALETTE, open, 2);
        for (int i = 0; i < 100; i++) {
            SceneBody asteroid = random.asteroid(world.snapshot()).orElseThrow();

            Outline outline = Objects.requireNonNull(asteroid.look()).outline();
            assertThat(asteroid.def().mass()).isEqualTo(0.5 * AsteroidOutline.area(outline));
            assertThat(asteroid.def().radius()).isBetween(3.0, 9.0);
            assertThat(speed(asteroid.def())).isBetween(Double.MIN_VALUE, 40.0);
        }
    }

    @Test
    void a_ship_is_the_palettes_and_slow() {
        BodyDef ship = new RandomBodies(PALETTE, open, 3)
                .ship(world.snapshot())
                .orElseThrow()
                .def();

        assertThat(ship.kind()).isEqualTo(BodyKind.SHIP);
        assertThat(ship.mass()).isEqualTo(12);
        assertThat(ship.radius()).isEqualTo(6);
        assertThat(ship.limits()).isEqualTo(PALETTE.shipLimits());
        assertThat(speed(ship)).isLessThanOrEqualTo(12);
    }

    @Test
    void any_is_each_kind_about_as_often() {
        RandomBodies random = new RandomBodies(PALETTE, open, 4);
        int[] seen = new int[BodyKind.values().length];
        for (int i = 0; i < 3000; i++) {
            seen[random.any(world.snapshot()).orElseThrow().def().kind().ordinal()]++;
        }

        // 3000 throws at 1/3: standard deviation √(3000 · 1/3 · 2/3) = 26; five of them.
        for (int count : seen) {
            assertThat(count).isCloseTo(1000, within(130));
        }
    }

    @Test
    void bodies_keep_a_gap_to_each_other_until_there_is_no_room() {
        RandomBodies random = new RandomBodies(PALETTE, open, 5);
        int added = 0;
        for (Optional<SceneBody> next = random.any(world.snapshot());
                next.isPresent();
                next = random.any(world.snapshot())) {
            BodyDef body = next.get().def();
            assertThat(smallestGap(world.snapshot(), body)).isGreaterThan(0.09 * body.radius());
            assertThat(AREA.contains(body.x(), body.y())).isTrue();
            world.add(body);
            added++;
        }

        // 80 000 square units; a body of radius 15 at most cannot spoil more than π · 32² of them.
        assertThat(added).isGreaterThan(25);
    }

    @Test
    void the_last_hole_in_a_crowd_is_found() {
        for (int column = -20; column < 20; column++) {
            for (int row = -10; row < 10; row++) {
                if (column != 3 || row != 2) {
                    world.add(BodyDef.planet(column * 10 + 5, row * 10 + 5, 1, 5));
                }
            }
        }
        Palette small = new Palette(
                AREA, new Range(2, 2), new Range(1, 1), new Range(2, 2), 1, 1, 1, 2, 1, new ShipLimits(1, 1));
        for (long seed = 0; seed < 20; seed++) {
            BodyDef ship = new RandomBodies(small, open, seed)
                    .ship(world.snapshot())
                    .orElseThrow()
                    .def();

            assertThat(ship.x()).as("seed %d", seed).isCloseTo(35, within(5.0));
            assertThat(ship.y()).as("seed %d", seed).isCloseTo(25, within(5.0));
        }
    }

    @Test
    void a_full_world_has_no_room() {
        world.add(BodyDef.planet(0, 0, 1, 1000));
        RandomBodies random = new RandomBodies(PALETTE, open, 6);

        assertThat(random.planet(world.snapshot())).isEmpty();
        assertThat(random.asteroid(world.snapshot())).isEmpty();
        assertThat(random.ship(world.snapshot())).isEmpty();
        assertThat(random.any(world.snapshot())).isEmpty();
    }

    @Test
    void bodies_are_born_inside_the_walls_even_where_the_area_reaches_beyond() {
        WorldSpec walled = WorldSpec.builder().walls(Aabb.centred(60, 60), 1).build();
        World inside = new World(walled);
        RandomBodies random = new RandomBodies(PALETTE, walled, 7);
        for (int i = 0; i < 200; i++) {
            BodyDef body = random.any(inside.snapshot()).orElseThrow().def();

            assertThat(Math.max(Math.abs(body.x()), Math.abs(body.y())) + body.radius())
                    .isLessThanOrEqualTo(60);
        }
    }

    @Test
    void a_body_at_the_seam_of_a_periodic_world_takes_room_on_both_sides() {
        WorldSpec periodic = WorldSpec.builder().periodic(AREA).build();
        World ring = new World(periodic);
        ring.add(BodyDef.planet(-200, 0, 1, 20));
        RandomBodies random = new RandomBodies(PALETTE, periodic, 8);
        for (int i = 0; i < 500; i++) {
            BodyDef body = random.ship(ring.snapshot()).orElseThrow().def();
            double across = 200 - Math.abs(body.x());

            assertThat(Math.sqrt(across * across + body.y() * body.y())).isGreaterThanOrEqualTo(20 + 6);
        }
    }

    @Test
    void the_same_seed_gives_the_same_bodies() {
        RandomBodies one = new RandomBodies(PALETTE, open, 9);
        RandomBodies same = new RandomBodies(PALETTE, open, 9);
        RandomBodies other = new RandomBodies(PALETTE, open, 10);
        WorldSnapshot now = world.snapshot();

        for (int i = 0; i < 20; i++) {
            BodyDef body = one.asteroid(now).orElseThrow().def();
            assertThat(same.asteroid(now).orElseThrow().def()).isEqualTo(body);
            assertThat(other.asteroid(now).orElseThrow().def()).isNotEqualTo(body);
        }
    }

    private static double speed(BodyDef body) {
        return Math.sqrt(body.vx() * body.vx() + body.vy() * body.vy());
    }

    private static double smallestGap(WorldSnapshot now, BodyDef body) {
        double smallest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < now.count(); i++) {
            double dx = now.x(i) - body.x();
            double dy = now.y(i) - body.y();
            smallest = Math.min(smallest, Math.sqrt(dx * dx + dy * dy) - now.radius(i) - body.radius());
        }
        return smallest;
    }
}

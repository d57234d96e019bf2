package io.github.apsis.engine.steering;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.Command;
import io.github.apsis.engine.ShipReading;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.engine.body.ShipLimits;
import io.github.apsis.engine.math.Rng;
import io.github.apsis.engine.math.Vec2;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The ways in which steering is known to fail, each with a ship of 8, 120 units/s and 200 units/s². Bodies pass through each other
 * here: what touches is seen, and not helped by a bounce.
 */
class AvoidanceTest {
    private static final ShipLimits LIMITS = new ShipLimits(120, 200);

    private final World world = new World(WorldSpec.builder().build());
    private double closest = Double.MAX_VALUE; // of ships to anything, between rims

    @Test
    void two_ships_that_meet_head_on_in_perfect_symmetry_do_not_wait_for_each_other() {
        BodyId left = seeker(-400, 0, 400, 0);
        BodyId right = seeker(400, 0, -400, 0);

        fly(10); // straight ahead it takes 8

        assertThat(closest).isGreaterThan(4);
        assertArrived(left, 400, 0);
        assertArrived(right, -400, 0);
    }

    @Test
    void the_mirror_image_of_a_meeting_is_flown_as_its_mirror_image() {
        World mirrored = new World(WorldSpec.builder().build());
        seeker(-400, 0, 400, 0);
        seeker(400, 2, -400, 2);
        seeker(mirrored, -400, 0, 400, 0);
        seeker(mirrored, 400, -2, -400, -2);

        for (int tick = 0; tick < 900; tick++) {
            world.step();
            mirrored.step();
            for (int i = 0; i < 2; i++) {
                assertThat(mirrored.snapshot().x(i)).isEqualTo(world.snapshot().x(i));
                assertThat(mirrored.snapshot().y(i)).isEqualTo(-world.snapshot().y(i));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {40, 96, 150})
    void a_ship_that_comes_past_its_target_at_full_speed_does_not_circle_it(double distance) {
        BodyId ship = world.add(ship(0, distance).moving(120, 0));
        world.apply(new Command.SeekTarget(ship, 0, 0));
        world.add(rock(30, -40, 15));
        world.add(rock(-45, 20, 15));

        fly(8);

        assertThat(closest).isGreaterThan(0);
        assertArrived(ship, 0, 0);
    }

    @Test
    void two_ships_that_are_in_each_others_way_at_rest_let_each_other_pass() {
        BodyId one = seeker(804, 573, 827, 562);
        BodyId other = seeker(828, 585, 809, 588);

        fly(10);

        assertThat(closest).isGreaterThan(0);
        assertArrived(one, 827, 562);
        assertArrived(other, 809, 588);
    }

    @Test
    void ships_that_cross_at_the_centre_of_a_circle_do_not_jam() {
        int count = 30;
        BodyId[] ships = new BodyId[count];
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * i / count;
            ships[i] = seeker(
                    300 * StrictMath.cos(angle),
                    300 * StrictMath.sin(angle),
                    -300 * StrictMath.cos(angle),
                    -300 * StrictMath.sin(angle));
        }

        fly(20); // straight ahead it takes 7

        assertThat(closest).isGreaterThan(0);
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * i / count;
            assertArrived(ships[i], -300 * StrictMath.cos(angle), -300 * StrictMath.sin(angle));
        }
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 4, 6}) // in these two ships overlapped, by up to 1.6, while that was only dear
    void ships_in_a_jam_of_240_break_away_before_they_overlap(long seed) {
        int count = 240;
        double radius = count * 20.9 / (2 * Math.PI); // 5 from rim to rim at the start
        var rng = new Rng(seed);
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * i / count;
            double x = radius * StrictMath.cos(angle);
            double y = radius * StrictMath.sin(angle);
            seeker(x + rng.between(-1, 1), y + rng.between(-1, 1), -x, -y);
        }

        fly(25);

        assertThat(closest).as("clearance of seed %d", seed).isGreaterThan(0);
    }

    @Test
    void a_ship_between_two_equal_threats_does_not_tremble() {
        BodyId ship = seeker(-300, 0, 400, 0);
        world.add(rock(0, 30, 20)); // a gap of 20 between them: 4 more than the ship is wide
        world.add(rock(0, -30, 20));

        double jerk = 0;
        Vec2 before = reading(ship).acceleration();
        for (int tick = 0; tick < 150 * 6; tick++) {
            step();
            Vec2 now = reading(ship).acceleration();
            jerk += Math.hypot(now.x() - before.x(), now.y() - before.y());
            before = now;
        }

        assertThat(closest).isGreaterThan(0);
        // In full forces a second. A ship that reverses its engine at every tick has 300; starting and stopping once
        // take 0.5.
        assertThat(jerk / 200 / 6).isLessThan(2);
        assertThat(world.snapshot().x(0)).isGreaterThan(100);
    }

    @Test
    void a_ship_is_not_pushed_onto_a_rock_by_ships_that_come_by() {
        seeker(0, 0, 0, 0);
        world.add(rock(0, 30, 15)); // 7 from rim to rim
        for (int i = 0; i < 8; i++) {
            seeker(-300 - 40 * i, -25 + (i % 2) * 10, 600, -25 + (i % 2) * 10);
        }

        fly(12);

        assertThat(closest).isGreaterThan(0);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 1e4, 1e7, -3e8})
    void far_from_the_origin_nobody_is_lost_from_sight(double away) {
        for (int i = 0; i < 6; i++) {
            seeker(away - 200, away - 50 + 20 * i, away + 200, away + 50 - 20 * i);
            seeker(away + 200, away - 50 + 20 * i, away - 200, away + 50 - 20 * i);
        }

        fly(8);

        assertThat(closest).isGreaterThan(0);
    }

    @Test
    void a_planet_that_no_engine_can_leave_is_given_a_wide_berth() {
        World pulled = new World(WorldSpec.builder().gravity(1).build());
        pulled.add(
                BodyDef.planet(0, 0, 3_200_000, 40).fixed()); // 2000 units/s² at its surface, 200 at a distance of 126
        BodyId ship = pulled.add(ship(-600, 5));
        pulled.apply(new Command.SeekTarget(ship, 600, 5));

        double nearest = Double.MAX_VALUE;
        for (int tick = 0; tick < 150 * 15; tick++) {
            pulled.step();
            WorldSnapshot now = pulled.snapshot();
            nearest = Math.min(nearest, Math.hypot(now.x(1), now.y(1)));
        }

        assertThat(nearest).isGreaterThan(126);
        assertThat(pulled.snapshot().x(1)).isCloseTo(600, within(0.1));
    }

    @ParameterizedTest
    @ValueSource(longs = {5, 6, 7, 8, 9, 10})
    void ships_of_different_size_speed_and_force_keep_clear_of_each_other(long seed) {
        var rng = new Rng(seed);
        for (int i = 0; i < 16; i++) {
            double radius = rng.between(3, 20);
            double speed = rng.between(40, 160);
            BodyDef def = BodyDef.ship(
                    i % 2 == 0 ? -350 : 350,
                    -320 + 45 * (i / 2) * 2 % 640 + rng.between(-2, 2),
                    radius * radius,
                    radius,
                    new ShipLimits(speed, radius * radius * rng.between(100, 300)));
            BodyId ship = world.add(def);
            world.apply(new Command.SeekTarget(ship, -def.x(), -def.y()));
        }

        fly(25);

        assertThat(closest).as("seed %d", seed).isGreaterThan(0);
    }

    @Test
    void small_fast_ships_give_way_to_a_freighter_that_can_hardly_turn() {
        BodyDef freighter = BodyDef.ship(0, -400, 400, 40, new ShipLimits(30, 400 * 6)); // needs 5 s and 75 to stop
        world.apply(new Command.SeekTarget(world.add(freighter), 0, 400));
        for (int i = 0; i < 24; i++) {
            double side = i % 2 == 0 ? 1 : -1;
            seeker(side * (300 + 30 * i), -300 + 25 * i, -side * 500, -300 + 25 * i);
        }

        fly(32); // straight ahead it takes 32

        assertThat(closest).isGreaterThan(0);
        assertThat(world.snapshot().y(0)).isGreaterThan(200);
    }

    @Test
    void a_ship_whose_target_lies_under_a_rock_waits_beside_it_and_arrives_when_it_has_gone() {
        BodyId ship = seeker(-200, 3, 0, 0);
        world.add(rock(-5, -20, 30).moving(0, 1.5)); // lies on the target for the first half minute

        fly(20);
        double whileCovered = Math.hypot(world.snapshot().x(0), world.snapshot().y(0));
        fly(30);

        assertThat(closest).isGreaterThan(0);
        assertThat(whileCovered)
                .isLessThan(60); // the rock reaches 40 from the target, the ship's centre is 8 farther out
        assertArrived(ship, 0, 0);
    }

    @Test
    void a_reading_tells_target_course_and_what_is_in_the_way() {
        BodyId ship = seeker(-100, 0, 100, 0);
        BodyId rock = world.add(rock(0, 1, 20));

        fly(0.2);

        ShipReading reading = reading(ship);
        assertThat(reading.target()).contains(new Vec2(100, 0));
        assertThat(reading.evading()).isTrue();
        assertThat(reading.course().length()).isPositive();
        assertThat(reading.acceleration().length()).isBetween(1.0, 200.001);
        assertThat(reading.threat().orElseThrow().body()).isEqualTo(rock);
        assertThat(reading.threat().orElseThrow().timeToContact()).isBetween(0.1, 2.5);
        assertThat(world.ship(rock)).isEmpty();
    }

    private BodyId seeker(double x, double y, double toX, double toY) {
        return seeker(world, x, y, toX, toY);
    }

    private static BodyId seeker(World in, double x, double y, double toX, double toY) {
        BodyId ship = in.add(ship(x, y));
        in.apply(new Command.SeekTarget(ship, toX, toY));
        return ship;
    }

    private static BodyDef ship(double x, double y) {
        return BodyDef.ship(x, y, 1, 8, LIMITS);
    }

    private static BodyDef rock(double x, double y, double radius) {
        return BodyDef.asteroid(x, y, 1, radius);
    }

    private void fly(double seconds) {
        for (int tick = 0; tick < 150 * seconds; tick++) {
            step();
        }
    }

    private void step() {
        world.step();
        WorldSnapshot now = world.snapshot();
        for (int i = 0; i < now.count(); i++) {
            for (int j = 0; j < now.count(); j++) {
                if (i != j && now.kind(i) == BodyKind.SHIP) {
                    double distance = Math.hypot(now.x(i) - now.x(j), now.y(i) - now.y(j));
                    closest = Math.min(closest, distance - now.radius(i) - now.radius(j));
                }
            }
        }
    }

    private ShipReading reading(BodyId ship) {
        return world.ship(ship).orElseThrow();
    }

    private void assertArrived(BodyId ship, double x, double y) {
        WorldSnapshot now = world.snapshot();
        int i = (int) ship.value() - 1;
        assertThat(now.id(i)).isEqualTo(ship);
        assertThat(Math.hypot(now.x(i) - x, now.y(i) - y))
                .as("distance of %s from its target", ship)
                .isLessThan(1);
    }
}

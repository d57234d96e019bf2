package io.github.apsis.engine.collision;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.Command;
import io.github.apsis.engine.Heaps;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyId;
import io.github.apsis.engine.math.Rng;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A heap at rest that nobody touches is not solved: nobody may find that out. */
class LyingHeapsTest {
    @ParameterizedTest
    @ValueSource(ints = {30, 100, Heaps.CIRCLES})
    void a_heap_that_is_struck_goes_on_to_the_bit_as_if_it_had_been_struck_at_once(int circles) {
        World now = Heaps.behindDam(circles);
        runUntilStill(now);
        now.step(); // the first tick in which it is left alone
        World later = Heaps.behindDam(circles);
        runUntilStill(later);
        run(later, (int) later.tick() + 500); // and the memory for solving it is given back

        strike(now);
        strike(later);
        run(now, (int) now.tick() + 150);
        run(later, (int) later.tick() + 150);

        WorldSnapshot one = now.snapshot();
        WorldSnapshot other = later.snapshot();
        assertThat(kineticEnergy(one)).isPositive();
        for (int i = 0; i < one.count(); i++) {
            assertThat(other.x(i)).as("circle %d", i).isEqualTo(one.x(i));
            assertThat(other.y(i)).as("circle %d", i).isEqualTo(one.y(i));
        }
    }

    @Test
    void its_weight_goes_through_the_books_in_every_tick() {
        World heap = Heaps.behindDam();
        runUntilStill(heap);
        double weight = Heaps.CIRCLES * 0.16 * Heaps.GRAVITY; // about
        double energy = heap.conserved().energy().orElseThrow() - heap.ledger().energy();
        double px = heap.conserved().momentumX() - heap.ledger().momentumX();
        double py = heap.conserved().momentumY() - heap.ledger().momentumY();
        double spin = heap.conserved().angularMomentum() - heap.ledger().angularMomentum();
        int ticks = 1500;

        run(heap, (int) heap.tick() + ticks);

        // Every tick rounds to the same side, each term of its sums by half a unit in the last place at most.
        double booked = weight / 150 * ticks * Heaps.CIRCLES * 0x1p-53;
        double height = 30;
        assertThat(kineticEnergy(heap.snapshot())).isZero();
        assertThat(heap.conserved().energy().orElseThrow() - heap.ledger().energy())
                .isCloseTo(energy, within(ticks * 0x1p-52 * energy));
        assertThat(heap.conserved().momentumX() - heap.ledger().momentumX()).isCloseTo(px, within(booked));
        assertThat(heap.conserved().momentumY() - heap.ledger().momentumY()).isCloseTo(py, within(booked));
        assertThat(heap.conserved().angularMomentum() - heap.ledger().angularMomentum())
                .isCloseTo(spin, within(height * booked));
    }

    @Test
    void what_slides_beside_it_slides_on_and_bounces_off_what_bears_it() {
        World heap = Heaps.behindDam();
        runUntilStill(heap);
        double beside = 20;
        BodyId slider = heap.add(BodyDef.asteroid(beside, 0.5, 1, 0.5).moving(-1, 0));
        double before = heap.conserved().momentumX() - heap.ledger().momentumX();

        run(heap, (int) heap.tick() + 75);

        WorldSnapshot sliding = heap.snapshot();
        int last = sliding.count() - 1;
        assertThat(sliding.id(last)).isEqualTo(slider);
        assertThat(sliding.vx(last)).isEqualTo(-1);
        assertThat(sliding.x(last)).isCloseTo(beside - 0.5, within(1e-12));
        assertThat(sliding.y(last)).isCloseTo(0.5, within(1e-12));

        run(heap, (int) heap.tick() + 750);

        assertThat(heap.snapshot().vx(last)).isCloseTo(0.2, within(1e-12)); // off the dam
        assertThat(heap.conserved().momentumX() - heap.ledger().momentumX()).isCloseTo(before, within(1e-11));
    }

    @ParameterizedTest
    @ValueSource(ints = {30, Heaps.CIRCLES})
    void it_comes_to_rest_beside_one_that_slides_for_ever(int circles) {
        World heap = Heaps.behindDam(circles);
        heap.add(BodyDef.asteroid(20, 0.5, 1, 0.5).moving(-1, 0));
        run(heap, 3000);
        WorldSnapshot before = heap.snapshot();

        run(heap, 3100);

        WorldSnapshot now = heap.snapshot();
        int slider = now.count() - 1;
        assertThat(now.vx(slider)).isCloseTo(0.2, within(150 * 1e-12)); // off the dam, with its rounding in a tick
        for (int i = 0; i < slider; i++) {
            assertThat(now.x(i)).as("circle %d", i).isEqualTo(before.x(i));
            assertThat(now.y(i)).as("circle %d", i).isEqualTo(before.y(i));
        }
    }

    @Test
    void it_falls_when_somebody_is_taken_from_under_it() {
        World heap = Heaps.behindDam();
        runUntilStill(heap);
        WorldSnapshot before = heap.snapshot();
        int lowest = before.count() - 1;
        for (int i = 0; i < before.count(); i++) {
            boolean lower = before.y(i) < before.y(lowest) && Math.abs(before.x(i) - 8) < 2;
            lowest = lower ? i : lowest;
        }

        heap.apply(new Command.RemoveBody(before.id(lowest)));
        run(heap, (int) heap.tick() + 300);

        WorldSnapshot after = heap.snapshot();
        double fallen = 0;
        for (int i = 0; i < after.count(); i++) {
            fallen = Math.max(fallen, before.y(i < lowest ? i : i + 1) - after.y(i));
        }
        assertThat(fallen).isGreaterThan(0.1);
    }

    @Test
    void it_takes_fifty_balls_of_any_weight_without_a_hole_in_the_books() {
        World heap = Heaps.behindDam();
        runUntilStill(heap);
        double energy = heap.conserved().energy().orElseThrow() - heap.ledger().energy();
        var rng = new Rng(3);
        for (int ball = 0; ball < 50; ball++) {
            double r = rng.between(0.1, 0.6);
            double m = Math.pow(10, rng.between(-4, 1));
            BodyId thrown = heap.add(
                    BodyDef.asteroid(rng.between(1, 15), 45, m, r).moving(rng.between(-5, 5), -rng.between(10, 50)));
            energy += m * Heaps.GRAVITY * 45
                    + kineticEnergy(heap.snapshot(), heap.snapshot().indexOf(thrown));
            run(heap, (int) heap.tick() + 30);
        }

        // Rounding alone, of three thousand ticks; 3e-15 in fact.
        assertThat(heap.conserved().energy().orElseThrow() - heap.ledger().energy())
                .isCloseTo(energy, within(1e-13 * energy));
    }

    private static void strike(World heap) {
        WorldSnapshot lying = heap.snapshot();
        int highest = 0;
        for (int i = 0; i < lying.count(); i++) {
            highest = lying.y(i) > lying.y(highest) ? i : highest;
        }
        double above = lying.y(highest) + lying.radius(highest) + 0.5 + 1e-3;
        heap.add(BodyDef.asteroid(lying.x(highest), above, 1, 0.5).moving(0.3, -8)); // touches in the next tick
    }

    private static void runUntilStill(World heap) {
        double[] at = new double[2 * heap.count()];
        boolean moves = true;
        while (moves) {
            assertThat(heap.tick()).as("ticks until it lies").isLessThan(3000);
            heap.step();
            WorldSnapshot now = heap.snapshot();
            moves = kineticEnergy(now) > 0;
            for (int i = 0; i < now.count(); i++) {
                moves |= at[2 * i] != now.x(i) || at[2 * i + 1] != now.y(i);
                at[2 * i] = now.x(i);
                at[2 * i + 1] = now.y(i);
            }
        }
    }

    private static double kineticEnergy(WorldSnapshot now) {
        double sum = 0;
        for (int i = 0; i < now.count(); i++) {
            sum += kineticEnergy(now, i);
        }
        return sum;
    }

    private static double kineticEnergy(WorldSnapshot now, int i) {
        return 0.5 * now.mass(i) * (now.vx(i) * now.vx(i) + now.vy(i) * now.vy(i));
    }
}

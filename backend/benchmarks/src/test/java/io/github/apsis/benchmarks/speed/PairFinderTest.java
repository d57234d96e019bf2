package io.github.apsis.benchmarks.speed;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.function.LongFunction;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

class PairFinderTest {
    private static final List<PairFinder> FINDERS =
            List.of(new CircleGridPairs(), new QuadtreePairs(), new GridPairs(), new JtsPairs(), new SweepPairs());

    private static Pairs found(PairFinder finder, Circles circles) {
        Pairs pairs = new Pairs();
        finder.find(circles, pairs);
        return pairs;
    }

    private static Pairs byLookingAtAll(Circles circles) {
        Pairs pairs = new Pairs();
        for (int i = 0; i < circles.count(); i++) {
            for (int j = i + 1; j < circles.count(); j++) {
                if (circles.overlap(i, j)) {
                    pairs.add(i, j);
                }
            }
        }
        return pairs;
    }

    @Test
    void all_find_the_same_pairs_as_a_look_at_all() {
        List<LongFunction<Circles>> kinds = List.of(
                seed -> Circles.equal(300, seed), seed -> Circles.mixed(300, seed), seed -> Circles.equal(1, seed));
        for (LongFunction<Circles> kind : kinds) {
            LongStream.range(0, 20).mapToObj(kind).forEach(circles -> {
                Pairs truth = byLookingAtAll(circles);
                assertThat(FINDERS)
                        .allSatisfy(finder ->
                                assertThat(found(finder, circles).wrong(truth)).isZero());
            });
        }
    }

    @Test
    void radii_of_mixed_circles_are_1_to_100_and_mostly_small() {
        double[] r = Circles.mixed(10_000, 7).r();

        assertThat(Arrays.stream(r)).allMatch(radius -> radius >= 1 && radius <= 100);
        // Of a density ∝ r⁻³ three quarters are below 2, and one in ten thousand above 71.
        assertThat(Arrays.stream(r).filter(radius -> radius < 2).count())
                .isBetween(7370L, 7630L); // three standard deviations
    }

    @Test
    void a_pair_missed_or_taken_for_another_is_wrong() {
        Pairs truth = new Pairs();
        truth.add(0, 1);
        truth.add(2, 3);
        Pairs one = new Pairs();
        one.add(1, 0);
        Pairs swapped = new Pairs();
        swapped.add(0, 1);
        swapped.add(2, 4);

        assertThat(one.wrong(truth)).isEqualTo(0.5);
        assertThat(swapped.wrong(truth)).isEqualTo(0.5);
        one.add(3, 2);
        assertThat(one.wrong(truth)).isZero();
    }
}

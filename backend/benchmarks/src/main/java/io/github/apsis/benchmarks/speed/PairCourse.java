package io.github.apsis.benchmarks.speed;

import java.util.List;

/** One finder over several sets of circles in turn, so that no branch can be learnt by heart; held against a sweep. */
final class PairCourse implements Course {
    private final List<Circles> sets;
    private final PairFinder finder;
    private final Pairs pairs = new Pairs();
    private int next;

    PairCourse(List<Circles> sets, PairFinder finder) {
        this.sets = sets;
        this.finder = finder;
    }

    @Override
    public void step() {
        pairs.clear();
        finder.find(sets.get(next), pairs);
        next = (next + 1) % sets.size();
    }

    @Override
    public List<Finding> findings() {
        double worst = 0;
        for (Circles circles : sets) {
            Pairs truth = new Pairs();
            new SweepPairs().find(circles, truth);
            pairs.clear();
            finder.find(circles, pairs);
            worst = Math.max(worst, pairs.wrong(truth));
        }
        return List.of(new Finding("pairs-wrong", worst));
    }
}

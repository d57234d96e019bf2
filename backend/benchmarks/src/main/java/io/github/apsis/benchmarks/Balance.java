package io.github.apsis.benchmarks;

import io.github.apsis.engine.World;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.diagnostics.Drift;
import java.util.OptionalDouble;

/**
 * What a world kept while it ran, and how deep its bodies lay in each other: asked now and then, outside the measured time. What a
 * body does between two looks is not seen.
 */
public final class Balance {
    private final World world;
    private final Conserved start;
    private final int bodiesAtStart;
    private Conserved now;
    private double worstEnergy;
    private double worstMomentum;
    private double worstAngularMomentum;
    private double deepestOverlap;
    private double deepestOverlapTime;
    private int mostTouching;

    /** Begins the books with the world as it is. */
    public Balance(World world) {
        this.world = world;
        this.start = world.conserved();
        this.now = start;
        this.bodiesAtStart = world.count();
    }

    /** Looks at the world as it is now. Costs as much as the forces of one tick. */
    public void look() {
        now = world.conserved();
        Drift drift = drift();
        worstEnergy = Math.max(worstEnergy, Math.abs(drift.energy().orElse(0)));
        worstMomentum = Math.max(worstMomentum, drift.momentum());
        worstAngularMomentum =
                Math.max(worstAngularMomentum, Math.abs(drift.angularMomentum().orElse(0)));
        Overlaps overlaps = Overlaps.of(world.snapshot(), world.spec().boundary());
        mostTouching = Math.max(mostTouching, overlaps.touching());
        if (overlaps.deepest() > deepestOverlap) {
            deepestOverlap = overlaps.deepest();
            deepestOverlapTime = world.time();
        }
    }

    /** From the beginning to the last look. */
    public Drift drift() {
        return Drift.between(start, now);
    }

    /** E − E₀; empty when a force law has no potential. */
    public OptionalDouble energyChange() {
        return start.energy().isPresent() && now.energy().isPresent()
                ? OptionalDouble.of(now.energy().getAsDouble() - start.energy().getAsDouble())
                : OptionalDouble.empty();
    }

    /** What engines, contacts and walls booked meanwhile. */
    public double work() {
        return now.booked().energy() - start.booked().energy();
    }

    /** The largest energy drift of all looks, without its sign. */
    public double worstEnergyDrift() {
        return worstEnergy;
    }

    public double worstMomentumDrift() {
        return worstMomentum;
    }

    public double worstAngularMomentumDrift() {
        return worstAngularMomentum;
    }

    public int bodiesAtStart() {
        return bodiesAtStart;
    }

    public int bodies() {
        return world.count();
    }

    /** Bodies that left the world of themselves. */
    public long departures() {
        return world.departed();
    }

    /** As a share of the smaller radius. */
    public double deepestOverlap() {
        return deepestOverlap;
    }

    public double deepestOverlapTime() {
        return deepestOverlapTime;
    }

    /** Of all looks, pairs. */
    public int mostTouching() {
        return mostTouching;
    }
}

package io.github.apsis.benchmarks.contacts;

import io.github.apsis.benchmarks.ContactMode;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.diagnostics.Conserved;
import java.util.List;

/** One case in one mode: a world that runs to the end of the case, and one more for each sample that no tick of it meets. */
final class ContactRun {
    private static final double TICKS_PER_FLIGHT = 4; // so that one falls between any two bounces
    private static final int MOST_PER_UNIT = 100_000;

    private final ContactCase known;
    private final ContactMode mode;
    private final int perUnit;
    private final Peak position = new Peak();
    private final Peak velocity = new Peak();
    private boolean finite = true;

    ContactRun(ContactCase known, ContactMode mode) {
        this.known = known;
        this.mode = mode;
        int meeting = SampleTicks.perUnit(
                known.samples().stream().map(MotionSample::time).toList());
        boolean watchesApexes =
                known.apexHeights().length > 0 && known.samples().isEmpty();
        this.perUnit = watchesApexes
                ? (int) Math.min(MOST_PER_UNIT, Math.max(meeting, Math.ceil(TICKS_PER_FLIGHT / known.shortestFlight())))
                : meeting;
    }

    double dt() {
        return 1.0 / perUnit;
    }

    ContactErrors errors() {
        World world = new World(known.spec(mode, dt()));
        BounceLog log = BounceLog.of(world, known.bodies());
        Conserved start = world.conserved();
        var energy = new EnergyBalance(known, start, world.snapshot());
        var momentum = new MomentumBalance(start, known.fieldImpulse());
        var apexes = new Apexes(known);
        long end = (long) Math.ceil(known.watched() * perUnit) + 1; // one more: the last bounce may come late
        long last = (long) Math.floor(known.end() * perUnit); // of which the case knows every bounce before
        for (long tick = 1; tick <= end && finite; tick++) {
            world.step();
            Conserved now = world.conserved();
            WorldSnapshot state = world.snapshot();
            energy.tick(now, state);
            apexes.look(state, log.bounces().size());
            requireFinite(state);
            if (look(state, tick) || tick == last) {
                energy.compare(now, state, world.time(), log.bounces());
            }
            momentum.tick(now);
        }
        known.samples().stream()
                .filter(sample -> !SampleTicks.meets(sample.time(), perUnit))
                .forEach(this::lookApart);
        compareApexes(apexes.heights());
        return new ContactErrors(
                finite,
                new EventOrder(known, List.copyOf(log.bounces())),
                position,
                velocity,
                energy.change(),
                energy.gain(),
                momentum.error(),
                apexes.heights());
    }

    private boolean look(WorldSnapshot state, long tick) {
        boolean any = false;
        for (MotionSample sample : known.samples()) {
            if (SampleTicks.meets(sample.time(), perUnit) && Math.rint(sample.time() * perUnit) == tick) {
                compare(sample, state);
                any = true;
            }
        }
        return any;
    }

    private void lookApart(MotionSample sample) {
        double dt = SampleTicks.dividing(sample.time(), dt());
        World world = new World(known.spec(mode, dt));
        known.bodies().forEach(world::add);
        long ticks = Math.round(sample.time() / dt);
        for (long tick = 0; tick < ticks; tick++) {
            world.step();
        }
        compare(sample, world.snapshot());
    }

    private void compare(MotionSample sample, WorldSnapshot state) {
        double limit = known.limit(sample.time());
        position.add(sample.positionError(state) / known.lengthScale(), limit, sample.time());
        velocity.add(sample.velocityError(state) / known.velocityScale(), limit, sample.time());
    }

    private void compareApexes(double[] heights) {
        for (int n = 0; n < Math.min(heights.length, known.events().size()); n++) {
            double time = known.events().get(n).time();
            position.add(Math.abs(heights[n] - known.apexHeights()[n]) / known.lengthScale(), known.limit(time), time);
        }
    }

    private void requireFinite(WorldSnapshot now) {
        finite = now.count() == known.bodies().size();
        for (int i = 0; i < now.count(); i++) {
            finite &= Double.isFinite(now.x(i) + now.y(i) + now.vx(i) + now.vy(i));
        }
    }
}

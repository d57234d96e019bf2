package io.github.apsis.engine.collision;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.diagnostics.Drift;
import io.github.apsis.engine.math.Rng;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;

/**
 * Two hundred bodies at rest around a planet fall on it and on each other, and lie on it half a minute later: all by mutual gravity, in an
 * open world, so that there is nobody to take momentum.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class AccretionTest {
    private static final int BODIES = Integer.getInteger("apsis.accretion", 200);
    private static final long SEED = 4;
    private static final double PLANET_MASS = 1000;
    private static final double PLANET_RADIUS = 10;

    private final World world = heap();
    private final Conserved start = world.conserved();
    private Conserved end = start;

    @BeforeAll
    void let_it_settle() {
        run(world, 30 * 150);
        end = world.conserved();
    }

    @Test
    void the_heap_is_at_rest() {
        double fallen =
                Math.abs(end.potential().orElseThrow() - start.potential().orElseThrow());
        // Circles without friction roll on for a while; what still moves is next to nothing of what has fallen.
        assertThat(end.kinetic() / fallen).as("seed %d", SEED).isLessThan(1e-6);
    }

    @Test
    void everybody_lies_on_the_planet_or_on_another_and_in_nobody() {
        assertThat(Depth.ofPairs(world.snapshot(), world.spec().boundary()))
                .as("seed %d", SEED)
                .isLessThan(0.05);
    }

    @Test
    void the_books_explain_where_the_energy_went() {
        double fallen =
                Math.abs(end.potential().orElseThrow() - start.potential().orElseThrow());
        double error = Drift.between(start, end).energy().orElseThrow()
                * (start.kinetic()
                        + Math.abs(start.potential().orElseThrow())
                        + Math.abs(end.booked().energy()));

        assertThat(end.energy().orElseThrow()).isLessThan(start.energy().orElseThrow());
        // Verlet, and contact times under a force that changes within the tick.
        assertThat(error / fallen).as("seed %d", SEED).isCloseTo(0, within(1e-3));
    }

    @Test
    void momentum_stays() {
        double px = end.momentumX() - start.momentumX();
        double py = end.momentumY() - start.momentumY();

        assertThat(Math.hypot(px, py) / fallingMomentum()).as("seed %d", SEED).isLessThan(1e-12);
    }

    @Test
    void angular_momentum_stays() {
        double arm = 20; // where most of them met
        // Parting an overlap moves bodies that have speed: what that adds is booked.
        double booked = end.booked().angularMomentum() - start.booked().angularMomentum();
        double error = end.angularMomentum() - start.angularMomentum() - booked;

        assertThat(error / (fallingMomentum() * arm)).as("seed %d", SEED).isCloseTo(0, within(1e-10));
    }

    /** What was under way in the fall: all the mass at the speed of a fall from far to 30. */
    private double fallingMomentum() {
        return mass() * Math.sqrt(2 * world.spec().gravity() * PLANET_MASS / 30);
    }

    private double mass() {
        WorldSnapshot now = world.snapshot();
        double sum = 0;
        for (int i = 1; i < now.count(); i++) {
            sum += now.mass(i);
        }
        return sum;
    }

    private static World heap() {
        World world = new World(WorldSpec.builder().gravity(1).contacts(0.3).build());
        world.add(BodyDef.planet(0, 0, PLANET_MASS, PLANET_RADIUS));
        var rng = new Rng(SEED);
        while (world.count() <= BODIES) {
            double r = rng.between(0.5, 1);
            double distance = rng.between(14, 45);
            double angle = rng.between(0, 2 * Math.PI);
            BodyDef body =
                    BodyDef.asteroid(distance * StrictMath.cos(angle), distance * StrictMath.sin(angle), r * r, r);
            if (isFree(world.snapshot(), body)) {
                world.add(body);
            }
        }
        return world;
    }

    private static boolean isFree(WorldSnapshot now, BodyDef body) {
        for (int i = 0; i < now.count(); i++) {
            if (Math.hypot(now.x(i) - body.x(), now.y(i) - body.y()) < now.radius(i) + body.radius()) {
                return false;
            }
        }
        return true;
    }
}

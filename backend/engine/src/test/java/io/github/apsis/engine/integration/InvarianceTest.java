package io.github.apsis.engine.integration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.ReferenceCase;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.WorldSpec.Integration;
import io.github.apsis.engine.body.Bodies;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.force.DirectGravity;
import io.github.apsis.engine.force.Forces;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.Executors;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tools.jackson.databind.JsonNode;

/** What every method owes to the symmetries of space and time, on the figure-eight of three bodies. */
class InvarianceTest {
    private static final int TICKS = 450; // half a period
    private static final double DT = WorldSpec.DEFAULT_DT;

    private static World world(Integration method, UnaryOperator<BodyDef> change) {
        World world = new World(
                WorldSpec.builder().gravity(1).integration(method).dt(DT).build());
        for (JsonNode body : ReferenceCase.of("figure8").node("bodies")) {
            world.add(change.apply(BodyDef.planet(
                            body.get("x").asDouble(),
                            body.get("y").asDouble(),
                            body.get("m").asDouble(),
                            0)
                    .moving(body.get("vx").asDouble(), body.get("vy").asDouble())));
        }
        return world;
    }

    private static WorldSnapshot after(Integration method, UnaryOperator<BodyDef> change) {
        return after(TICKS, method, change);
    }

    private static WorldSnapshot after(int ticks, Integration method, UnaryOperator<BodyDef> change) {
        World world = world(method, change);
        ReferenceCase.run(world, ticks);
        return world.snapshot();
    }

    private static BodyDef at(BodyDef body, double x, double y, double vx, double vy) {
        return BodyDef.planet(x, y, body.mass(), 0).moving(vx, vy);
    }

    @ParameterizedTest
    @EnumSource(Integration.class)
    void elsewhere_and_in_motion_the_same_happens(Integration method) {
        int ticks = 150;
        WorldSnapshot here = after(ticks, method, body -> body);

        WorldSnapshot there = after(
                ticks, method, body -> at(body, body.x() + 1000, body.y() - 1000, body.vx() + 10, body.vy() - 10));

        // Positions near 1000 are 1.1e-13 apart, each tick rounds them once to four times, and the orbit amplifies that
        // fivefold.
        double x = 1000 + 10 * ticks * DT;
        for (int i = 0; i < 3; i++) {
            assertThat(there.x(i) - x).isCloseTo(here.x(i), within(1e-11));
            assertThat(there.y(i) + x).isCloseTo(here.y(i), within(1e-11));
        }
    }

    @ParameterizedTest
    @EnumSource(Integration.class)
    void turned_by_any_angle_the_same_happens(Integration method) {
        double cos = 0.28;
        double sin = 0.96;
        WorldSnapshot here = after(method, body -> body);

        WorldSnapshot turned = after(
                method,
                body -> at(
                        body,
                        cos * body.x() - sin * body.y(),
                        sin * body.x() + cos * body.y(),
                        cos * body.vx() - sin * body.vy(),
                        sin * body.vx() + cos * body.vy()));

        for (int i = 0; i < 3; i++) {
            assertThat(turned.x(i)).isCloseTo(cos * here.x(i) - sin * here.y(i), within(1e-12));
            assertThat(turned.y(i)).isCloseTo(sin * here.x(i) + cos * here.y(i), within(1e-12));
        }
    }

    @ParameterizedTest
    @EnumSource(Integration.class)
    void in_a_mirror_the_same_happens_to_the_bit(Integration method) {
        WorldSnapshot here = after(method, body -> body);

        WorldSnapshot mirrored = after(method, body -> at(body, -body.x(), body.y(), -body.vx(), body.vy()));

        for (int i = 0; i < 3; i++) {
            assertThat(mirrored.x(i)).isEqualTo(-here.x(i));
            assertThat(mirrored.vy(i)).isEqualTo(here.vy(i));
        }
    }

    @ParameterizedTest
    @EnumSource(Integration.class)
    void in_another_order_the_same_happens(Integration method) {
        WorldSnapshot here = after(method, body -> body);
        World reversed = new World(
                WorldSpec.builder().gravity(1).integration(method).dt(DT).build());
        WorldSnapshot start = world(method, body -> body).snapshot();
        for (int i = 2; i >= 0; i--) {
            reversed.add(BodyDef.planet(start.x(i), start.y(i), 1, 0).moving(start.vx(i), start.vy(i)));
        }

        ReferenceCase.run(reversed, TICKS);

        // The sums have another order, so their rounding differs; half a period amplifies it twentyfold.
        for (int i = 0; i < 3; i++) {
            assertThat(reversed.snapshot().x(2 - i)).isCloseTo(here.x(i), within(1e-12));
        }
    }

    @ParameterizedTest
    @EnumSource(Integration.class)
    void momentum_and_angular_momentum_stay(Integration method) {
        World world = world(method, body -> body);
        var start = world.conserved();

        ReferenceCase.run(world, 10_000);

        // A random walk of roundings: 1e-15 · √ticks of the scale; a composition rounds once a stage.
        double walk = (method == Integration.YOSHIDA4 || method == Integration.PEFRL ? 2e-15 : 1e-15) * 100;
        assertThat(world.conserved().momentumX()).isCloseTo(start.momentumX(), within(walk * start.momentumScale()));
        assertThat(world.conserved().momentumY()).isCloseTo(start.momentumY(), within(walk * start.momentumScale()));
        assertThat(world.conserved().angularMomentum()).isCloseTo(start.angularMomentum(), within(walk));
    }

    @ParameterizedTest
    @EnumSource(
            value = Integration.class,
            names = {"VELOCITY_VERLET", "YOSHIDA4", "PEFRL", "SYMPLECTIC8"})
    void a_symmetric_method_runs_backwards_to_where_it_came_from(Integration method) {
        Integrator integrator =
                switch (method) {
                    case VELOCITY_VERLET -> new VelocityVerlet();
                    case YOSHIDA4 -> new Yoshida4();
                    case PEFRL -> new Pefrl();
                    default -> new Symplectic8();
                };
        var bodies = new Bodies();
        bodies.add(BodyDef.planet(-0.25, 0, 0.5, 0).moving(0, -0.866));
        bodies.add(BodyDef.planet(0.25, 0, 0.5, 0).moving(0, 0.866));
        var forces = new Forces(List.of(new DirectGravity(1, 0)));

        for (double dt : new double[] {DT, -DT}) {
            for (int tick = 0; tick < 1000; tick++) {
                integrator.advance(bodies, forces, dt);
            }
        }

        // Time-reversible but for rounding, which an orbit amplifies about linearly.
        assertThat(bodies.x(1)).isCloseTo(0.25, within(1e-12));
        assertThat(bodies.vy(1)).isCloseTo(0.866, within(1e-12));
    }

    @ParameterizedTest
    @EnumSource(Integration.class)
    void the_same_bits_come_again_on_any_number_of_threads(Integration method) throws Exception {
        Callable<Long> run = () -> {
            World world = world(method, body -> body);
            ReferenceCase.run(world, TICKS);
            return world.stateHash();
        };
        long alone = run.call();

        var pool = Executors.newFixedThreadPool(8);
        try {
            for (var hash : pool.invokeAll(List.of(run, run, run, run, run, run, run, run))) {
                assertThat(hash.get()).isEqualTo(alone);
            }
        } finally {
            pool.shutdownNow();
        }
    }

    @Test
    void every_method_has_its_bits() {
        // The same on every JDK and machine: a change is a change of the physics.
        assertThat(Integration.values())
                .extracting(method -> {
                    World world = world(method, body -> body);
                    ReferenceCase.run(world, TICKS);
                    return Long.toHexString(world.stateHash());
                })
                .containsExactly(
                        "b41c5b658075ca6f",
                        "1403259ce5e9510f",
                        "d17be436771ee2c0",
                        "dccc324131851377",
                        "24ccde4cb89e0e61",
                        "a85890061879546c");
    }
}

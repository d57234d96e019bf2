package io.github.apsis.engine.collision;

import static io.github.apsis.engine.ReferenceCase.run;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import io.github.apsis.engine.ReferenceCase;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.WorldSpec.Integration;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.math.Rng;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.databind.JsonNode;

/** Exact contacts without gravity: on the parabolas of Verlet's ticks, and on the series of the adaptive method. */
class ExactContactsTest {
    /** Of times, speeds, impulses and places, times what a case itself makes of an error in its start. */
    private static final double EXACT = 1e-12;

    private static final double DT = 1.0 / 100; // the samples of the cases fall on such ticks

    private record Bounce(double time, long first, long second, double closingSpeed, double impulse) {}

    static Stream<Arguments> casesAndMethods() {
        return Stream.of(
                        "pair-head-on-e00",
                        "pair-head-on-e05",
                        "pair-head-on-e08",
                        "pair-head-on-e10",
                        "pair-oblique-e00",
                        "pair-oblique-e05",
                        "pair-oblique-e08",
                        "pair-oblique-e10",
                        "cradle-e10",
                        "cradle-e09",
                        "bullet-hit",
                        "bullet-graze",
                        "bullet-miss",
                        "floor-drop",
                        "gas100")
                .flatMap(id -> Stream.of(
                        Arguments.of(id, Integration.VELOCITY_VERLET), Arguments.of(id, Integration.ADAPTIVE)));
    }

    @ParameterizedTest
    @MethodSource("casesAndMethods")
    void every_bounce_has_its_time_its_partners_and_its_impulse(String id, Integration method) {
        ReferenceCase contacts = ReferenceCase.of(id);
        World world = contacts.world(spec(contacts, method));
        List<Bounce> bounces = new ArrayList<>();
        world.onBounce((time, a, b, c, impulse) -> bounces.add(new Bounce(time, a, b, c, impulse)));

        JsonNode amplification = contacts.node("conditioning").get("amplification");
        int k = 0;
        int event = 0;
        for (ReferenceCase.Sample sample : contacts.samples()) {
            run(world, sample.tick(DT));
            double tolerance = EXACT * Math.max(1, amplification.get(k++).asDouble());
            while (event < contacts.node("events").size()
                    && contacts.node("events").get(event).get("t").asDouble() <= sample.time()) {
                assertThat(bounces).as("bounces until %s", sample.time()).hasSizeGreaterThan(event);
                assertBounce(bounces.get(event), contacts.node("events").get(event), tolerance, contacts);
                event++;
            }
            assertThat(sample.positionError(world.snapshot()) / contacts.number("length_scale"))
                    .as("positions at %s", sample.time())
                    .isLessThanOrEqualTo(tolerance);
            assertThat(sample.velocityError(world.snapshot()) / contacts.number("velocity_scale"))
                    .as("velocities at %s", sample.time())
                    .isLessThanOrEqualTo(tolerance);
        }
        assertThat(bounces).hasSize(contacts.node("event_count").asInt());
    }

    private static WorldSpec spec(ReferenceCase contacts, Integration method) {
        var spec = WorldSpec.builder()
                .dt(DT)
                .integration(method)
                .exactContacts(contacts.number("restitution"))
                .halfPlanes(contacts.walls(), contacts.number("wall_restitution"));
        double down = contacts.node("uniform_g").get(1).asDouble();
        return (down == 0 ? spec : spec.law(new UniformField(0, down))).build();
    }

    private static void assertBounce(Bounce bounce, JsonNode truth, double tolerance, ReferenceCase contacts) {
        String partner = truth.get("j").asString();
        assertThat(bounce.first()).isEqualTo(truth.get("i").asInt() + 1);
        assertThat(bounce.second())
                .isEqualTo(
                        partner.startsWith("w")
                                ? -1 - Integer.parseInt(partner.substring(1))
                                : Integer.parseInt(partner) + 1);
        double scale = contacts.number("velocity_scale");
        assertThat(bounce.time()).isCloseTo(truth.get("t").asDouble(), within(tolerance));
        assertThat(bounce.closingSpeed()).isCloseTo(-truth.get("vn").asDouble(), within(tolerance * scale));
        assertThat(bounce.impulse()).isCloseTo(truth.get("impulse").asDouble(), within(tolerance * scale));
    }

    @ParameterizedTest
    @EnumSource(names = {"VELOCITY_VERLET", "ADAPTIVE"})
    void a_ball_bounces_on_until_its_flights_are_a_thousandth_of_a_tick(Integration method) {
        ReferenceCase drop = ReferenceCase.of("floor-drop");
        World world = drop.world(spec(drop, method));
        List<Bounce> bounces = new ArrayList<>();
        world.onBounce((time, a, b, c, impulse) -> bounces.add(new Bounce(time, a, b, c, impulse)));

        run(world, 1000);

        // 9.9 · 0.8ⁿ is above 9.81 · 1e-5 / 2 until n = 54; the series would end at 9.0867 s.
        assertThat(bounces).hasSize(55);
        assertThat(bounces.get(50).time()).isCloseTo(9.0867, within(1e-3));
        assertThat(world.snapshot().y(0)).isCloseTo(0.25, within(1e-9));
        assertThat(world.snapshot().vy(0)).isCloseTo(0, within(1e-9));
    }

    @ParameterizedTest
    @EnumSource(names = {"VELOCITY_VERLET", "ADAPTIVE"})
    void an_elastic_ball_bounces_ten_thousand_times_to_the_same_height(Integration method) {
        World world = new World(WorldSpec.builder()
                .integration(method)
                .exactContacts(1)
                .law(new UniformField(0, -10))
                .halfPlanes(List.of(new Boundary.HalfPlane(0, 1, 0)), 1)
                .build());
        world.add(BodyDef.asteroid(0, 1.05, 1, 1)); // a flight lasts 0.2 s
        Conserved before = world.conserved();

        run(world, 300_000);

        double now = world.conserved().energy().orElseThrow();
        // A bounce is wrong by a rounding or two, which add up like a random walk.
        assertThat(now / before.energy().orElseThrow() - 1).isCloseTo(0, within(1e-12));
    }

    @Test
    void a_gas_keeps_its_energy_through_a_million_collisions() {
        World world = new World(WorldSpec.builder()
                .dt(0.05)
                .exactContacts(1)
                .walls(Aabb.centred(20, 20), 1)
                .build());
        long seed = 8;
        var rng = new Rng(seed);
        for (int i = 0; i < 200; i++) {
            double x = -18.5 + 2.6 * (i % 15);
            double y = -18.5 + 2.6 * (i / 15);
            world.add(BodyDef.asteroid(x, y, rng.between(0.5, 2), rng.between(0.6, 1.25))
                    .moving(rng.between(-5, 5), rng.between(-5, 5)));
        }
        int[] bounces = {0};
        world.onBounce((time, a, b, c, impulse) -> bounces[0]++);
        double before = world.conserved().kinetic();

        while (bounces[0] < 1_000_000) {
            world.step();
        }

        // A collision is wrong by a rounding of what two of 200 have, and a million of them by a thousand roundings.
        assertThat(world.conserved().kinetic() / before - 1).as("seed %d", seed).isCloseTo(0, within(1e-13));
    }

    @Test
    void exact_contacts_under_gravity_ask_for_the_adaptive_method() {
        assertThatThrownBy(() -> WorldSpec.builder().gravity(1).exactContacts(1).build())
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("adaptive");
        assertThatThrownBy(() -> WorldSpec.builder()
                        .integration(Integration.SEMI_IMPLICIT_EULER)
                        .exactContacts(1)
                        .build())
                .isInstanceOf(IllegalStateException.class)
                .hasMessageContaining("Euler");
        assertThat(WorldSpec.builder()
                        .gravity(1)
                        .adaptive(1e-16)
                        .exactContacts(1)
                        .build()
                        .maxBodies())
                .isEqualTo(256);
    }
}

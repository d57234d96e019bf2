package io.github.apsis.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.github.apsis.engine.Departure;
import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSnapshot;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.body.BodyKind;
import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.engine.math.Period;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What holds for every scene. */
class SceneCatalogueTest {
    private static final long SEED = 11;

    static Stream<String> names() {
        return SceneCatalogue.all().stream().map(Scene::name);
    }

    static Stream<String> scalableNames() {
        return SceneCatalogue.all().stream()
                .filter(ScalableScene.class::isInstance)
                .map(Scene::name);
    }

    private static Scene scene(String name) {
        return SceneCatalogue.byName(name).orElseThrow();
    }

    @Test
    void names_are_unique_and_written_like_words_in_an_address() {
        assertThat(names()).doesNotHaveDuplicates().allMatch(name -> name.matches("[a-z]+(-[a-z]+)*"));
    }

    @Test
    void an_unknown_name_is_nothing() {
        assertThat(SceneCatalogue.byName("flatland")).isEmpty();
        assertThat(SceneCatalogue.byName("flatland", 5)).isEmpty();
    }

    @ParameterizedTest
    @MethodSource("scalableNames")
    void a_scene_that_scales_has_the_number_of_bodies_that_was_asked_for(String name) {
        for (int count : new int[] {20, 251, 1000}) {
            Scene scene = SceneCatalogue.byName(name, count).orElseThrow();

            assertThat(scene.bodies(SEED)).hasSize(count);
            assertFreeOfOverlap(scene);
        }
    }

    @Test
    void a_scene_of_one_size_says_so() {
        assertThatThrownBy(() -> SceneCatalogue.byName("two-bodies", 5))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("two-bodies comes in one size only")
                .hasMessageContaining("elastic-gas");
    }

    @ParameterizedTest
    @ValueSource(ints = {-1, 0, 1})
    void a_size_that_makes_no_sense_is_refused(int count) {
        assertThat(scalableNames()).allSatisfy(name -> assertThatThrownBy(() -> SceneCatalogue.byName(name, count))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("or more, was " + count));
    }

    @ParameterizedTest
    @MethodSource("names")
    void no_bodies_overlap_at_birth(String name) {
        assertFreeOfOverlap(scene(name));
    }

    @ParameterizedTest
    @MethodSource("names")
    void every_body_is_born_inside_the_edge(String name) {
        Boundary edge = scene(name).spec(SEED).boundary();

        assertThat(scene(name).bodies(SEED))
                .extracting(SceneBody::def)
                .allMatch(body -> edge.holds(body.x(), body.y(), body.radius()));
    }

    @ParameterizedTest
    @MethodSource("names")
    void asteroids_have_an_outline_and_nothing_else_has(String name) {
        assertThat(scene(name).bodies(SEED))
                .allMatch(body -> (body.def().kind() == BodyKind.ASTEROID) == (body.look() != null));
    }

    @ParameterizedTest
    @MethodSource("names")
    void the_same_seed_ends_in_the_same_state(String name) {
        assertThat(stateAfter(scene(name), SEED)).isEqualTo(stateAfter(scene(name), SEED));
    }

    @ParameterizedTest
    @ValueSource(strings = {"belt-and-swarm", "asteroid-field", "elastic-gas"})
    void another_seed_ends_in_another_state(String name) {
        assertThat(stateAfter(scene(name), SEED)).isNotEqualTo(stateAfter(scene(name), SEED + 1));
    }

    @ParameterizedTest
    @MethodSource("names")
    void ten_seconds_pass_and_bodies_stay_apart(String name) {
        World world = scene(name).world(SEED);
        for (int tick = 0; tick < 1500; tick++) {
            world.step(); // throws when a body leaves the numbers
        }

        // A contact at rest may be pressed in a little while others push: far less than can be seen.
        assertThat(smallestGap(world.snapshot(), world.spec())).isGreaterThan(-0.02);
    }

    @ParameterizedTest
    @MethodSource("names")
    void people_can_add_twenty_bodies_of_each_kind(String name) {
        Scene scene = scene(name);
        World world = scene.world(SEED);
        RandomBodies random = new RandomBodies(scene.palette(), world.spec(), SEED);
        for (int i = 0; i < 20; i++) {
            world.add(random.planet(world.snapshot()).orElseThrow().def());
            world.add(random.asteroid(world.snapshot()).orElseThrow().def());
            world.add(random.ship(world.snapshot()).orElseThrow().def());
        }
        for (int tick = 0; tick < 300; tick++) {
            world.step();
        }

        // Where ships are mortal, one that comes into the way of a rock may be gone; nobody is lost in any other way.
        assertThat(world.departures())
                .allMatch(departure -> departure.reason() == Departure.Reason.COLLIDED
                        && world.spec().shipsAreMortal());
        assertThat(world.count() + world.departures().size())
                .isEqualTo(scene.bodies(SEED).size() + 60);
    }

    private static long stateAfter(Scene scene, long seed) {
        World world = scene.world(seed);
        for (int tick = 0; tick < 50; tick++) {
            world.step();
        }
        return world.stateHash();
    }

    private static void assertFreeOfOverlap(Scene scene) {
        List<BodyDef> bodies = scene.bodies(SEED).stream().map(SceneBody::def).toList();
        World world = new World(scene.spec(SEED));
        bodies.forEach(world::add);

        assertThat(smallestGap(world.snapshot(), world.spec())).isPositive();
    }

    /** Between the rims of any two bodies, across the seam as well. */
    private static double smallestGap(WorldSnapshot now, WorldSpec spec) {
        Period period = spec.boundary() instanceof Boundary.Periodic p ? new Period(p.box()) : null;
        double smallest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < now.count(); i++) {
            for (int j = 0; j < i; j++) {
                double dx = now.x(i) - now.x(j);
                double dy = now.y(i) - now.y(j);
                if (period != null) {
                    dx = period.nearestX(dx);
                    dy = period.nearestY(dy);
                }
                smallest = Math.min(smallest, Math.sqrt(dx * dx + dy * dy) - now.radius(i) - now.radius(j));
            }
        }
        return smallest;
    }
}

package io.github.apsis.scenes;

import java.util.List;
import java.util.Optional;

/** All scenes by name. */
public final class SceneCatalogue {
    private static final List<Scene> SCENES = List.of(
            new BeltAndSwarm(),
            new SolarSystem(),
            new AsteroidField(AsteroidField.Ships.BOUNCE),
            new AsteroidField(AsteroidField.Ships.MORTAL),
            new ElasticGas(),
            new TwoBodies(),
            new FigureEight(),
            new Empty());

    private SceneCatalogue() {}

    /** Every scene in its usual size, in the order in which people like to see them. */
    public static List<Scene> all() {
        return SCENES;
    }

    /** The scene of this name in its usual size; empty when there is none. */
    public static Optional<Scene> byName(String name) {
        return SCENES.stream().filter(scene -> scene.name().equals(name)).findFirst();
    }

    /**
     * The scene of this name with so many bodies; empty when there is none.
     *
     * @throws IllegalArgumentException when the scene comes in one size only, or not in this one
     */
    public static Optional<Scene> byName(String name, int bodies) {
        return byName(name).map(scene -> resize(scene, bodies));
    }

    private static Scene resize(Scene scene, int bodies) {
        if (scene instanceof ScalableScene scalable) {
            return scalable.withBodies(bodies);
        }
        throw new IllegalArgumentException("the scene " + scene.name()
                + " comes in one size only; those that scale are " + String.join(", ", scalableNames()));
    }

    private static List<String> scalableNames() {
        return SCENES.stream()
                .filter(ScalableScene.class::isInstance)
                .map(Scene::name)
                .toList();
    }
}

package io.github.apsis.benchmarks.speed;

import java.util.List;

/** All scenes, in the order of the page. */
final class SpeedScenes {
    private static final List<SpeedScene> ALL = List.of(
            new GasScene(),
            new FallScene(),
            new PileScene(),
            GravityScene.direct(),
            GravityScene.tree(),
            GravityScene.ladder(),
            new BroadPhaseScene(BroadPhaseScene.Radii.EQUAL),
            new BroadPhaseScene(BroadPhaseScene.Radii.MIXED),
            new ShipScene(),
            new FleetScene(),
            RoomScene.alone(),
            RoomScene.hundred(),
            new Moonshot(),
            new FrameScene());

    private SpeedScenes() {}

    static List<SpeedScene> all() {
        return ALL;
    }

    static List<String> names() {
        return ALL.stream().map(SpeedScene::name).toList();
    }

    /**
     * The scenes of these names, all where none is named.
     *
     * @throws IllegalArgumentException when there is no such scene; the message lists them
     */
    static List<SpeedScene> named(List<String> names) {
        for (String name : names) {
            if (!names().contains(name)) {
                throw new IllegalArgumentException(
                        "There is no scene " + name + ". Scenes: " + String.join(", ", names()));
            }
        }
        return names.isEmpty()
                ? ALL
                : ALL.stream().filter(scene -> names.contains(scene.name())).toList();
    }
}

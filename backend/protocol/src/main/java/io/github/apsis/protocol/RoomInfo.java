package io.github.apsis.protocol;

import org.jspecify.annotations.Nullable;

/** What a client must know about a room once: its scene, its units, its edge and its limits. */
public record RoomInfo(
        String room,
        String scene,
        String title,
        Units units,
        Edge boundary,
        Box view,
        int tickRate,
        int frameRate,
        int maxBodies) {

    /** Names of the units, for people. */
    public record Units(String length, String mass, String time) {}

    /** A part of the world. */
    public record Box(double minX, double minY, double maxX, double maxY) {}

    /**
     * The edge of the world.
     *
     * @param kind {@code open}, {@code walls} or {@code periodic}; an open world has no numbers, and none travel
     */
    public record Edge(
            String kind, @Nullable Double minX, @Nullable Double minY, @Nullable Double maxX, @Nullable Double maxY) {
        public static Edge open() {
            return new Edge("open", null, null, null, null);
        }

        public static Edge of(String kind, Box box) {
            return new Edge(kind, box.minX(), box.minY(), box.maxX(), box.maxY());
        }
    }
}

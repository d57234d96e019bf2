package io.github.apsis.protocol;

import java.util.Locale;
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
        int maxBodies,
        Ships ships) {

    /** What becomes of a ship that runs into another body. Travels in lower case. */
    public enum Ships {
        /** It goes on. */
        BOUNCE,
        /** It is gone. */
        MORTAL;

        private final String wireName = name().toLowerCase(Locale.ROOT);

        @Override
        public String toString() {
            return wireName;
        }
    }

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

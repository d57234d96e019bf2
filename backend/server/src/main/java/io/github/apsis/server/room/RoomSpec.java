package io.github.apsis.server.room;

import io.github.apsis.scenes.Scene;

/**
 * What a room is opened with, and replaced with after a failure.
 *
 * @param id names the room
 * @param seed of the scene and of the random bodies
 * @param framesPerSecond divides {@link TickLoop#TICKS_PER_SECOND}
 * @param maxBodies beyond which nobody can add one; no more than the scene can bear
 */
public record RoomSpec(String id, Scene scene, long seed, int framesPerSecond, int maxBodies) {
    public RoomSpec {
        if (framesPerSecond < 1 || TickLoop.TICKS_PER_SECOND % framesPerSecond != 0) {
            throw new IllegalArgumentException("the frame rate must divide " + TickLoop.TICKS_PER_SECOND
                    + " (150, 75, 50, 30, 25, 15, 10 …), was " + framesPerSecond);
        }
        if (maxBodies < 1) {
            throw new IllegalArgumentException("a room must hold at least one body, maxBodies was " + maxBodies);
        }
        maxBodies = Math.min(maxBodies, scene.spec(seed).maxBodies());
    }
}

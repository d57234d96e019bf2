package io.github.apsis.scenes;

import io.github.apsis.engine.body.BodyDef;
import org.jspecify.annotations.Nullable;

/** A body of a scene: what the physics needs, and how it looks where that is more than its circle. */
public record SceneBody(BodyDef def, @Nullable Look look) {
    /** A body that looks like its circle, or like every other of its kind. */
    static SceneBody plain(BodyDef def) {
        return new SceneBody(def, null);
    }

    SceneBody at(double x, double y) {
        return new SceneBody(def.at(x, y), look);
    }

    SceneBody moving(double vx, double vy) {
        return new SceneBody(def.moving(vx, vy), look);
    }
}

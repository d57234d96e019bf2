package io.github.apsis.server.room;

import io.github.apsis.engine.body.BodyId;

/** What a client may ask of a room. */
public sealed interface Request {
    /** Adds a random body of the scene's palette. */
    record AddRandom(RandomBody what) implements Request {}

    /** Selects a body for the client. */
    record Select(BodyId body) implements Request {}

    /** Ends the client's selection of a body. */
    record Deselect(BodyId body) implements Request {}

    /** Removes a body. */
    record Remove(BodyId body) implements Request {}

    /** Sends the ships that the client has selected to a point, in formation. */
    record MoveSelectedShips(double x, double y) implements Request {}

    /** Which random body. */
    enum RandomBody {
        PLANET,
        ASTEROID,
        SHIP,
        ANY
    }
}

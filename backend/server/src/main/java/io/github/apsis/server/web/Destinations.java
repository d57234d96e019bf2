package io.github.apsis.server.web;

import java.util.Set;

/** Every destination of the treaty. What is not here is refused. */
final class Destinations {
    static final String ENDPOINT = "/physics-engine-websocket";
    static final String BODIES = "/topic/bodies";
    static final String DIAGNOSTICS = "/topic/diagnostics";
    static final String EVENTS = "/topic/events";
    static final String SHIP = "/user/queue/ship";
    static final String REPLIES = "/queue/replies";
    static final String ERRORS = "/queue/errors";

    static final Set<String> COMMANDS = Set.of(
            "/app/random-planet",
            "/app/random-asteroid",
            "/app/random-spaceship",
            "/app/random-body",
            "/app/select-body",
            "/app/delete-body",
            "/app/move-selected-spaceships");

    /** Where only the newest message counts. */
    static final Set<String> STREAMS = Set.of(BODIES, DIAGNOSTICS, EVENTS, SHIP);

    static final Set<String> ANSWERS = Set.of("/app/room", "/user" + REPLIES, "/user" + ERRORS);

    private Destinations() {}
}

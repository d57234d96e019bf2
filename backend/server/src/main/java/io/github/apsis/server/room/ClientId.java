package io.github.apsis.server.room;

/** One session of a client: what a selection belongs to. */
public record ClientId(String value) {}

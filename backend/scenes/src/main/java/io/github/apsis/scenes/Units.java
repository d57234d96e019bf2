package io.github.apsis.scenes;

/** The names of a scene's units, for people. */
public record Units(String length, String mass, String time) {}

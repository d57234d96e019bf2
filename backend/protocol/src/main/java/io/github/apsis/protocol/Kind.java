package io.github.apsis.protocol;

import java.util.Locale;

/** What a body is. Travels in lower case. */
public enum Kind {
    PLANET,
    ASTEROID,
    SHIP;

    private final String wireName = name().toLowerCase(Locale.ROOT);

    @Override
    public String toString() {
        return wireName;
    }
}

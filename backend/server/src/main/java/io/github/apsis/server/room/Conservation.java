package io.github.apsis.server.room;

import io.github.apsis.engine.diagnostics.Conserved;
import io.github.apsis.engine.diagnostics.Drift;

/**
 * What a world keeps, and what that did beyond the work of engines, contacts and walls since the bodies were last
 * changed.
 */
public record Conservation(Conserved now, Drift drift) {}

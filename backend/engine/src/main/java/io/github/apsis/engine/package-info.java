/** The physics engine: {@link io.github.apsis.engine.World} is a simulation, everything else is a part of its tick. */
@NullMarked
package io.github.apsis.engine;

import org.jspecify.annotations.NullMarked;

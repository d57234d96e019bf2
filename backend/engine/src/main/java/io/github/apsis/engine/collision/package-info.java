/** Contacts between circles and with the edge of the world. */
@NullMarked
package io.github.apsis.engine.collision;

import org.jspecify.annotations.NullMarked;

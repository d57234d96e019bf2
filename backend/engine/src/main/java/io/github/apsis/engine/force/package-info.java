/** Laws that accelerate bodies: gravity by direct sum, uniform fields, and what users write. */
@NullMarked
package io.github.apsis.engine.force;

import org.jspecify.annotations.NullMarked;

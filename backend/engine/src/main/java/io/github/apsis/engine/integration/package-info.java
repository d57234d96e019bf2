/** How positions and velocities advance under the forces. */
@NullMarked
package io.github.apsis.engine.integration;

import org.jspecify.annotations.NullMarked;

/** How a tick advances: the integrator, then contacts, then the edge of the world. */
@NullMarked
package io.github.apsis.engine.stepping;

import org.jspecify.annotations.NullMarked;

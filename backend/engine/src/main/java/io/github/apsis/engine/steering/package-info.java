/** How ships decide: one thrust per ship and tick. */
@NullMarked
package io.github.apsis.engine.steering;

import org.jspecify.annotations.NullMarked;

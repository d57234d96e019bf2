/** Numbers without physics: boxes, vectors, sums, seeded random numbers. */
@NullMarked
package io.github.apsis.engine.math;

import org.jspecify.annotations.NullMarked;

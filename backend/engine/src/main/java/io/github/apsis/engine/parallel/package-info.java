/** Several threads on one piece of work, with the same bits for any number of them. */
@NullMarked
package io.github.apsis.engine.parallel;

import org.jspecify.annotations.NullMarked;

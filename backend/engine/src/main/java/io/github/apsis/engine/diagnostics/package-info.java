/** Conserved quantities, computed when asked, with compensated sums. */
@NullMarked
package io.github.apsis.engine.diagnostics;

import org.jspecify.annotations.NullMarked;

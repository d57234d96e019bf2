/** The command {@code apsis-bench}. */
@NullMarked
package io.github.apsis.benchmarks.cli;

import org.jspecify.annotations.NullMarked;

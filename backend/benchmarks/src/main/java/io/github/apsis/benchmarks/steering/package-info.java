/** How well ships steer: scenes that are specified to the bit, run with every way to steer, ours and others'. */
@NullMarked
package io.github.apsis.benchmarks.steering;

import org.jspecify.annotations.NullMarked;

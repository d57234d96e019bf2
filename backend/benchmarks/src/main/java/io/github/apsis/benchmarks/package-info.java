/** Speed against error: how fast a world ticks, and how far it strays from what physics conserves. */
@NullMarked
package io.github.apsis.benchmarks;

import org.jspecify.annotations.NullMarked;

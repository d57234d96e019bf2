/** Scenes of discs without friction, and the engines that can run them: ours, dyn4j and JBox2D. */
@NullMarked
package io.github.apsis.benchmarks.discs;

import org.jspecify.annotations.NullMarked;

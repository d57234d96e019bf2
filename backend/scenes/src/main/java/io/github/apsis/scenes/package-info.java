/** Worlds worth looking at, from code; shared by the server, the tests and the benchmarks. */
@NullMarked
package io.github.apsis.scenes;

import org.jspecify.annotations.NullMarked;

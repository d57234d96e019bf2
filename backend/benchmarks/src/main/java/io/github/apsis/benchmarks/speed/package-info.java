/** What a tick costs against the number of bodies, with the error that it has in the same run. */
@NullMarked
package io.github.apsis.benchmarks.speed;

import org.jspecify.annotations.NullMarked;

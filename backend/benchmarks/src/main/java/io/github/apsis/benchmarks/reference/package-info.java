/** Reading cases in the reference format: JSON whose numbers may be strings, in a folder or in the program itself. */
@NullMarked
package io.github.apsis.benchmarks.reference;

import org.jspecify.annotations.NullMarked;

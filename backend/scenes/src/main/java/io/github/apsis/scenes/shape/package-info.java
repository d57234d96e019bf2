/** How an asteroid looks: the one place that uses JTS. */
@NullMarked
package io.github.apsis.scenes.shape;

import org.jspecify.annotations.NullMarked;

/** Where bodies are: the quadtree, rebuilt each tick. */
@NullMarked
package io.github.apsis.engine.spatial;

import org.jspecify.annotations.NullMarked;

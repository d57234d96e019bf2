/** Where bodies are: a quadtree for gravity and for what ships see, grids for what may touch; both made anew each tick. */
@NullMarked
package io.github.apsis.engine.spatial;

import org.jspecify.annotations.NullMarked;

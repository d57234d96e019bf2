/** What a body is: the columns that hold all of them, and the values that go in. */
@NullMarked
package io.github.apsis.engine.body;

import org.jspecify.annotations.NullMarked;

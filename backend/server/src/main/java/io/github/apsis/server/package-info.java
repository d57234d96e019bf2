/** The server: rooms on a clock, and Spring around them. */
@NullMarked
package io.github.apsis.server;

import org.jspecify.annotations.NullMarked;

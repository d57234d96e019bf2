/** How what travels is written as JSON. */
@NullMarked
package io.github.apsis.protocol.json;

import org.jspecify.annotations.NullMarked;

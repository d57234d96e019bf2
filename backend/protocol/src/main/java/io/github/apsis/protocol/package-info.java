/** What travels between the server and the page: records without behaviour. The treaty is {@code docs/protocol}. */
@NullMarked
package io.github.apsis.protocol;

import org.jspecify.annotations.NullMarked;

/** Cases whose contacts are known: how far each mode of contacts strays from them, and at what price, beside other engines. */
@NullMarked
package io.github.apsis.benchmarks.contacts;

import org.jspecify.annotations.NullMarked;

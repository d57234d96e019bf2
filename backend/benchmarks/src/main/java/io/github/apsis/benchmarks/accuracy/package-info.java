/** Cases with known right answers: how far each method strays from them, at what price, beside REBOUND. */
@NullMarked
package io.github.apsis.benchmarks.accuracy;

import org.jspecify.annotations.NullMarked;

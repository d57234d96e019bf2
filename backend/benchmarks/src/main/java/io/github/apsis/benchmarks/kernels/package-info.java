/**
 * Kernels by themselves, for JMH: {@code java -cp apsis-bench.jar org.openjdk.jmh.Main -prof gc}. What a whole tick costs, and
 * with which error, {@code apsis-bench speed} says.
 */
@NullMarked
package io.github.apsis.benchmarks.kernels;

import org.jspecify.annotations.NullMarked;

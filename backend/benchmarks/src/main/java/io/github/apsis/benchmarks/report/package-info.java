/** What a report is made of: tables for programs and for people, charts, and the name of the machine. */
@NullMarked
package io.github.apsis.benchmarks.report;

import org.jspecify.annotations.NullMarked;

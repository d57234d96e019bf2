package io.github.apsis.benchmarks.speed;

/**
 * What a step costs.
 *
 * @param ms of CPU time of the stepping thread; on several threads by the clock
 * @param p99Ms by the clock, which others on the machine stretch too
 * @param bytes allocated by the stepping thread, in the second half
 */
record StepCost(double ms, double p99Ms, double bytes) {}

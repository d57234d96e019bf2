package io.github.apsis.server.room;

import io.github.apsis.engine.math.Vec2;
import java.util.OptionalDouble;

/**
 * Energy and momentum of a world, and what they did beyond the work of engines, contacts and walls since the bodies
 * were last changed.
 *
 * @param energy kinetic + potential; empty when a force has no potential
 * @param energyDrift relative to kinetic energy + |potential energy|
 * @param momentumDrift relative to Σ|m·v|
 */
public record Conservation(OptionalDouble energy, OptionalDouble energyDrift, Vec2 momentum, double momentumDrift) {}

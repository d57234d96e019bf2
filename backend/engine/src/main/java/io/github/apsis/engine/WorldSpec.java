package io.github.apsis.engine;

import io.github.apsis.engine.collision.Boundary;
import io.github.apsis.engine.collision.Boundary.HalfPlane;
import io.github.apsis.engine.collision.ContactMode;
import io.github.apsis.engine.force.ForceLaw;
import io.github.apsis.engine.force.UniformField;
import io.github.apsis.engine.integration.AdaptiveTaylor;
import io.github.apsis.engine.math.Aabb;
import io.github.apsis.engine.parallel.Team;
import io.github.apsis.engine.steering.SteeringSpec;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * What a world is made of. Only what a spec names is in the tick: without gravity no pair is visited, without contacts no
 * tree is built.
 *
 * <pre>{@code
 * WorldSpec spec = WorldSpec.builder().gravity(16).contacts(0.8).walls(Aabb.centred(1000, 1000), 0.8).seed(7).build();
 * }</pre>
 */
public final class WorldSpec {
    /** The tick of 150 Hz, in seconds. */
    public static final double DEFAULT_DT = 1.0 / 150;

    /** The fastest that an engine of this kind is asked to hold. */
    public static final int DEFAULT_MAX_BODIES = 100_000;

    private final double gravity;
    private final double softening;
    private final GravityMethod gravityMethod;
    private final List<ForceLaw> laws;
    private final Integration integration;
    private final double tolerance;
    private final OptionalDouble restitution;
    private final ContactMode contactMode;
    private final Boundary boundary;
    private final SteeringSpec steering;
    private final boolean mortalShips;
    private final double dt;
    private final long seed;
    private final int maxBodies;
    private final int threads;

    private WorldSpec(Builder builder) {
        gravity = builder.gravity;
        softening = builder.softening;
        gravityMethod = builder.gravityMethod;
        laws = List.copyOf(builder.laws);
        integration = builder.integration;
        tolerance = builder.tolerance;
        restitution = builder.restitution;
        contactMode = builder.contactMode;
        boundary = builder.boundary;
        steering = builder.steering;
        mortalShips = builder.mortalShips;
        dt = builder.dt;
        seed = builder.seed;
        maxBodies = builder.maxBodies;
        threads = builder.threads;
    }

    public static Builder builder() {
        return new Builder();
    }

    /** G in length³ / (mass · time²); 0 for a world without attraction. */
    public double gravity() {
        return gravity;
    }

    /** Plummer softening, length; 0 for Newton's law. */
    public double softening() {
        return softening;
    }

    /** How gravity is summed. */
    public GravityMethod gravityMethod() {
        return gravityMethod;
    }

    /** Further laws beside gravity. */
    public List<ForceLaw> laws() {
        return laws;
    }

    public Integration integration() {
        return integration;
    }

    /** Error of an adaptive step, relative to each separation. */
    public double tolerance() {
        return tolerance;
    }

    /** Share of the normal speed that is left after a contact; empty for a world without contacts. */
    public OptionalDouble restitution() {
        return restitution;
    }

    /** How exactly contacts are told from rest. */
    public ContactMode contactMode() {
        return contactMode;
    }

    public Boundary boundary() {
        return boundary;
    }

    /** Distance to its target at which a ship begins to slow down, length. */
    public double slowingRadius() {
        return steering.slowingRadius();
    }

    /** How ships steer. */
    public SteeringSpec steering() {
        return steering;
    }

    /** Whether a ship that runs into another body leaves the world; otherwise it bounces and goes on. */
    public boolean shipsAreMortal() {
        return mortalShips;
    }

    /** Length of a tick, time. */
    public double dt() {
        return dt;
    }

    /**
     * The time at a tick, from the count and never a sum: tick · dt, and tick / n where dt is the double nearest to 1/n. So
     * it is wrong by half a unit in its last place, at any tick.
     */
    public double timeAt(long tick) {
        double ticksPerTime = Math.rint(1 / dt);
        return dt == 1 / ticksPerTime ? tick / ticksPerTime : tick * dt;
    }

    public long seed() {
        return seed;
    }

    public int maxBodies() {
        return maxBodies;
    }

    /** How many threads share the work of a tick, the one that calls {@link World#step} among them. */
    public int threads() {
        return threads;
    }

    /**
     * The same world, stepped by so many threads, with the same bits.
     *
     * @param count 1 to {@link Team#MOST}
     */
    public WorldSpec withThreads(int count) {
        return new Builder(this).threads(count).build();
    }

    /** How gravity is summed. */
    public sealed interface GravityMethod {
        /** Every pair, exactly. */
        record Direct() implements GravityMethod {}

        /** By a tree of this opening angle. */
        record Tree(double theta) implements GravityMethod {}

        /** By whatever is cheapest and keeps this relative error for nine bodies of ten. */
        record Adaptive(double forceError) implements GravityMethod {}
    }

    /** How positions and velocities advance; docs/accuracy says what each costs and how wrong it is. */
    public enum Integration {
        /** Order 1, one evaluation of the forces a tick; for comparison. */
        SEMI_IMPLICIT_EULER,
        /** Order 2, symplectic, one evaluation: for crowds and for contacts. */
        VELOCITY_VERLET,
        /** Order 4, symplectic, three evaluations. */
        YOSHIDA4,
        /** Order 4, symplectic, four evaluations and a far smaller error than Yoshida's. */
        PEFRL,
        /** Order 8, symplectic, seventeen evaluations, compensated: for long runs with long ticks. */
        SYMPLECTIC8,
        /** Steps of their own length to a tolerance: for few bodies, close encounters and numbers to rely on. */
        ADAPTIVE
    }

    /** Collects the parts of a world; what is not named is not in it. */
    public static final class Builder {
        private double gravity;
        private double softening;
        private GravityMethod gravityMethod = new GravityMethod.Direct();
        private final List<ForceLaw> laws = new ArrayList<>();
        private Integration integration = Integration.VELOCITY_VERLET;
        private double tolerance = 1e-16;
        private OptionalDouble restitution = OptionalDouble.empty();
        private ContactMode contactMode = ContactMode.TICK;
        private Boundary boundary = new Boundary.Open();
        private SteeringSpec steering = SteeringSpec.DEFAULT;
        private boolean mortalShips;
        private double dt = DEFAULT_DT;
        private long seed;
        private int maxBodies = DEFAULT_MAX_BODIES;
        private int threads = 1;

        private Builder() {}

        private Builder(WorldSpec like) {
            gravity = like.gravity;
            softening = like.softening;
            gravityMethod = like.gravityMethod;
            laws.addAll(like.laws);
            integration = like.integration;
            tolerance = like.tolerance;
            restitution = like.restitution;
            contactMode = like.contactMode;
            boundary = like.boundary;
            steering = like.steering;
            mortalShips = like.mortalShips;
            dt = like.dt;
            seed = like.seed;
            maxBodies = like.maxBodies;
            threads = like.threads;
        }

        /** Newtonian attraction between every pair, with this G in length³ / (mass · time²). */
        public Builder gravity(double bigG) {
            this.gravity = requirePositive("gravity", bigG);
            return this;
        }

        /** Plummer softening of the attraction, length. */
        public Builder softening(double length) {
            this.softening = requirePositive("softening", length);
            return this;
        }

        /** Gravity by a tree of this opening angle, above 0 and at most 1: 0.5 is right to 1e-4 for most bodies. */
        public Builder tree(double theta) {
            if (!(theta > 0 && theta <= 1)) {
                throw new IllegalArgumentException("theta must be above 0 and at most 1, was " + theta);
            }
            this.gravityMethod = new GravityMethod.Tree(theta);
            return this;
        }

        /**
         * Gravity by the cheapest sum that keeps this relative error for nine bodies of ten, above 0 and below 1; the tenth
         * may be worse where its pulls nearly cancel.
         */
        public Builder forceError(double relative) {
            if (!(relative > 0 && relative < 1)) {
                throw new IllegalArgumentException("a force error must be above 0 and below 1, was " + relative);
            }
            this.gravityMethod = new GravityMethod.Adaptive(relative);
            return this;
        }

        /** One more force law, for example a uniform field; it belongs to this world alone. */
        public Builder law(ForceLaw law) {
            laws.add(law);
            return this;
        }

        public Builder integration(Integration method) {
            this.integration = method;
            return this;
        }

        /**
         * Integrates adaptively: every step keeps each separation to this tolerance relative to itself, 1e-16 to 1e-2. For
         * gravity summed directly, uniform fields and thrust, and for no more than 256 bodies.
         */
        public Builder adaptive(double relativeError) {
            if (!(relativeError >= 1e-16 && relativeError <= 1e-2)) {
                throw new IllegalArgumentException("tolerance must be 1e-16 to 1e-2, was " + relativeError);
            }
            this.tolerance = relativeError;
            return integration(Integration.ADAPTIVE);
        }

        /**
         * Bodies collide, and leave a contact with this share of their normal speed. Made for crowds: bounces have their true
         * times on the parabola of a tick, which is the true path in a uniform field and of order two under gravity; what closes
         * no faster than the forces push in two ticks lies at rest.
         */
        public Builder contacts(double coefficient) {
            return contacts(coefficient, ContactMode.TICK);
        }

        /**
         * Bodies collide in the order of the true times, at true places, to rounding: for elastic gases, cradles, billiards and
         * what bounces on planets. Without gravity by any method whose path is the true one; under gravity with {@link #adaptive}
         * alone, whose series is the path, and for no more than 256 bodies. What would fly for less than a thousandth of a tick
         * before its next bounce lies at rest, and after 1000 bounces in one tick a body's contacts are inelastic unless nothing
         * is lost: so what would bounce infinitely often in finite time does not.
         */
        public Builder exactContacts(double coefficient) {
            return contacts(coefficient, ContactMode.EXACT);
        }

        private Builder contacts(double coefficient, ContactMode mode) {
            if (!(coefficient >= 0 && coefficient <= 1)) {
                throw new IllegalArgumentException("restitution must be 0 to 1, was " + coefficient);
            }
            this.restitution = OptionalDouble.of(coefficient);
            this.contactMode = mode;
            return this;
        }

        /** Four reflecting walls. */
        public Builder walls(Aabb box, double wallRestitution) {
            this.boundary = new Boundary.Walls(box, wallRestitution);
            return this;
        }

        /** Reflecting walls in any direction, for example a floor. */
        public Builder halfPlanes(List<HalfPlane> insides, double wallRestitution) {
            this.boundary = new Boundary.HalfPlanes(insides, wallRestitution);
            return this;
        }

        /** A world that repeats itself. */
        public Builder periodic(Aabb box) {
            this.boundary = new Boundary.Periodic(box);
            return this;
        }

        public Builder slowingRadius(double length) {
            this.steering = steering.slowingWithin(length);
            return this;
        }

        /** How ships steer, slowing radius included. */
        public Builder steering(SteeringSpec how) {
            this.steering = how;
            return this;
        }

        /**
         * Ships do not survive a bounce with another body: when the tick is over they leave the world, as a {@link Departure}. What they
         * hit has got its impulse; energy and momentum leave with them. Walls do no harm, and what lies at rest against a ship from
         * the beginning does none either.
         */
        public Builder mortalShips() {
            this.mortalShips = true;
            return this;
        }

        /** Length of a tick, in the time unit of the scene; with 0 the world stands still. */
        public Builder dt(double tick) {
            if (!(tick >= 0) || Double.isInfinite(tick)) {
                throw new IllegalArgumentException("dt must be 0 or more and finite, was " + tick);
            }
            this.dt = tick;
            return this;
        }

        /** Seed of everything random in the world. */
        public Builder seed(long value) {
            this.seed = value;
            return this;
        }

        public Builder maxBodies(int limit) {
            this.maxBodies = (int) requirePositive("maxBodies", limit);
            return this;
        }

        /**
         * Lets so many threads share the work of a tick, 1 to 256, the one that calls {@link World#step} among them; it is the
         * same world to the last bit for any number. They are daemons, begin when a tick has enough work for them, which for
         * gravity is about a thousand bodies, and end with {@link World#close}.
         */
        public Builder threads(int count) {
            if (count < 1 || count > Team.MOST) {
                throw new IllegalArgumentException("threads must be 1 to " + Team.MOST + ", was " + count);
            }
            this.threads = count;
            return this;
        }

        /**
         * The world as described.
         *
         * @throws IllegalStateException when its parts do not go together; the message says which
         */
        public WorldSpec build() {
            if (!(gravityMethod instanceof GravityMethod.Direct)) {
                requireTreeIsPossible();
            }
            if (integration == Integration.ADAPTIVE) {
                requireAdaptable();
            }
            if (contactMode == ContactMode.EXACT && integration != Integration.ADAPTIVE) {
                requireParabolas();
            }
            if (mortalShips && restitution.isEmpty()) {
                throw new IllegalStateException(
                        "mortal ships need something to run into: call contacts(restitution) too, or leave out mortalShips");
            }
            return new WorldSpec(this);
        }

        /** Without gravity and in uniform fields the parabola of a tick is the true path. */
        private void requireParabolas() {
            if (gravity != 0) {
                throw new IllegalStateException(
                        "exact contacts under gravity are found on the paths of the adaptive method:"
                                + " call adaptive(tolerance) too, or contacts(restitution) for a crowd");
            }
            for (ForceLaw law : laws) {
                if (!(law instanceof UniformField)) {
                    throw new IllegalStateException("exact contacts know gravity and uniform fields, not "
                            + law.getClass().getSimpleName() + "; choose contacts(restitution)");
                }
            }
            if (integration == Integration.SEMI_IMPLICIT_EULER) {
                throw new IllegalStateException(
                        "the paths of semi-implicit Euler are not the true ones: choose another method for exact contacts");
            }
        }

        private void requireAdaptable() {
            for (ForceLaw law : laws) {
                if (!(law instanceof UniformField)) {
                    throw new IllegalStateException("adaptive integration knows gravity and uniform fields, not "
                            + law.getClass().getSimpleName() + "; choose a symplectic method for it");
                }
            }
            if (boundary instanceof Boundary.Periodic) {
                throw new IllegalStateException(
                        "adaptive integration does not know periodic worlds; choose a symplectic method for them");
            }
            if (!(gravityMethod instanceof GravityMethod.Direct)) {
                throw new IllegalStateException(
                        "adaptive integration sums gravity directly: leave out tree and forceError");
            }
            maxBodies = Math.min(maxBodies, AdaptiveTaylor.MOST_BODIES);
        }

        private void requireTreeIsPossible() {
            if (boundary instanceof Boundary.Periodic) {
                throw new IllegalStateException("a periodic world sums nearest images: leave out tree and forceError");
            }
            if (gravity == 0) {
                throw new IllegalStateException("tree and forceError need gravity: call gravity(G) too");
            }
        }

        private static double requirePositive(String name, double value) {
            if (!(value > 0) || Double.isInfinite(value)) {
                throw new IllegalArgumentException(name + " must be positive and finite, was " + value);
            }
            return value;
        }
    }
}

package io.github.apsis.benchmarks.speed;

import io.github.apsis.engine.World;
import io.github.apsis.engine.WorldSpec;
import io.github.apsis.engine.WorldSpec.Integration;
import io.github.apsis.engine.body.BodyDef;
import io.github.apsis.engine.math.Rng;

/** Equal masses at rest, strewn evenly over a disc: G = 1 and m = 1. */
record MassDisc(int count, double radius, double softening) {
    /**
     * Nobody gets anywhere in such a tick, but each one evaluates the forces once; the rest of it is below 1 % from 1000 bodies.
     */
    private static final double NO_TIME = 1e-18;

    private static final long SEED = 12345;

    /** The laws, with gravity summed directly; a caller may choose another sum. */
    WorldSpec.Builder laws() {
        WorldSpec.Builder laws = WorldSpec.builder()
                .gravity(1)
                .integration(Integration.SEMI_IMPLICIT_EULER)
                .dt(NO_TIME)
                .maxBodies(count);
        return softening > 0 ? laws.softening(softening) : laws;
    }

    World world(WorldSpec spec) {
        World world = new World(spec);
        Rng rng = new Rng(SEED);
        for (int i = 0; i < count; i++) {
            double r = radius * Math.sqrt(rng.nextDouble());
            double angle = rng.between(0, 2 * Math.PI);
            world.add(BodyDef.planet(r * StrictMath.cos(angle), r * StrictMath.sin(angle), 1, 0));
        }
        return world;
    }
}
